#include "player/overlay/overlays.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "player/overlay/frame_caption.h"

namespace ribbon::overlays_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Overlays, words_stand_in_any_order) {
  const Overlays overlays = parse_overlays("time,wireframe").value();
  EXPECT_TRUE(overlays.time && overlays.wireframe);
  EXPECT_FALSE(overlays.frame || overlays.numbers || overlays.obstacle_wireframe || overlays.curve);
  const Overlays all =
      parse_overlays("numbers,frame,obstacle-wireframe,time,wireframe,curve").value();
  EXPECT_TRUE(all.time && all.wireframe && all.frame && all.numbers && all.obstacle_wireframe &&
              all.curve);
}

TEST(Overlays, an_unknown_word_is_told_with_those_that_there_are) {
  for (const char* text : {"", "time,", ",", "wire", "Time", "time wireframe"})
    EXPECT_THAT(
        parse_overlays(text).error().sentence(),
        HasSubstr("write some of wireframe, obstacle-wireframe, curve, frame, time, numbers"))
        << text;
}

TEST(FrameCaption, tells_what_was_asked_for) {
  FrameNumbers numbers{0.4, 0.0412, 0, 5};
  EXPECT_THAT(frame_caption({}, 12, numbers), IsEmpty());
  EXPECT_THAT(frame_caption({.frame = true}, 12, numbers), ElementsAre("frame 12"));
  EXPECT_THAT(frame_caption({.time = true}, 12, numbers), ElementsAre("0.40 s"));
  EXPECT_THAT(frame_caption({.time = true}, 12, numbers, "bow"), ElementsAre("0.40 s · bow"));
  EXPECT_THAT(frame_caption({.frame = true, .time = true, .numbers = true}, 12, numbers),
              ElementsAre("frame 12 · 0.40 s", "strain 4.1 %"));
  EXPECT_THAT(frame_caption({.frame = true}, 12.25, numbers),
              ElementsAre("frame 12.25", "interpolated"));
  EXPECT_THAT(frame_caption({}, 12.25, numbers), IsEmpty());
  numbers.penetrating_edges = 1;
  numbers.tightness = TightnessNumbers{0.5F, 0, 0.75F, 0.25F, 0};
  EXPECT_THAT(frame_caption({.numbers = true}, 12, numbers),
              ElementsAre("strain 4.1 % · 1 penetration",
                          "progress 50.0 % · pull 75.0 % · in contact 25.0 %"));
}

TEST(FrameCaption, stays_within_a_small_picture) {
  const Color black(0, 0, 0);
  Picture picture = blank_picture({320, 200}, black);
  draw_caption({"frame 12 · 0.40 s · the left end is laid over the knot and led round behind it"},
               CaptionPainter(), picture);
  EXPECT_NE(*picture.pixel(160, 20), 0);
  for (int y = 0; y < 200; ++y) EXPECT_EQ(*picture.pixel(315, y), 0) << y;
}

}  // namespace ribbon::overlays_test
