#include "player/picture/caption.h"

#include <gtest/gtest.h>

namespace ribbon::caption_test {

const Color white(1, 1, 1);
const Color black(0, 0, 0);

// How many pixels of the box are darker than paper.
int inked(const Picture& picture, int left, int top, int right, int bottom) {
  int count = 0;
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) count += *picture.pixel(x, y) < 250 ? 1 : 0;
  return count;
}

TEST(Caption, letters_stand_on_their_baseline) {
  Picture picture = blank_picture({100, 40}, white);
  CaptionPainter().draw("HE", 10, 30, 20, black, picture);
  EXPECT_GT(inked(picture, 10, 12, 45, 30), 50);
  EXPECT_EQ(inked(picture, 0, 30, 100, 40), 0);
  EXPECT_EQ(inked(picture, 0, 0, 10, 40), 0);
}

TEST(Caption, the_width_is_what_is_drawn) {
  const CaptionPainter painter;
  const int width = painter.width("frame 12", 15);
  EXPECT_GT(width, 50);
  EXPECT_EQ(painter.width("frame 12frame 12", 15), 2 * width);
  Picture picture = blank_picture({200, 30}, white);
  painter.draw("frame 12", 0, 20, 15, black, picture);
  EXPECT_EQ(inked(picture, width, 0, 200, 30), 0);
}

TEST(Caption, what_does_not_fit_is_shortened_by_whole_characters) {
  const CaptionPainter painter;
  const std::string text = "fold é over and under";
  const int all = painter.width(text, 15);
  EXPECT_EQ(painter.fitted(text, 15, all), text);
  for (int room = all - 1; room > 15; --room) {
    const std::string shorter = painter.fitted(text, 15, room);
    EXPECT_LE(painter.width(shorter, 15), room);
    ASSERT_TRUE(shorter.ends_with("…"));
    EXPECT_TRUE(text.starts_with(shorter.substr(0, shorter.size() - 3)));
    EXPECT_FALSE(shorter.ends_with("\xC3…")) << "half a letter";
  }
  EXPECT_EQ(painter.fitted(text, 15, 0), "…");
}

TEST(Caption, text_outside_the_picture_is_left_out) {
  Picture picture = blank_picture({20, 20}, white);
  CaptionPainter().draw("a long line of text", -30, 5, 15, black, picture);
  CaptionPainter().draw("below", 0, 400, 15, black, picture);
  EXPECT_GT(inked(picture, 0, 0, 20, 20), 0);
}

TEST(Caption, every_language_of_the_font_is_drawn_and_broken_bytes_do_no_harm) {
  const CaptionPainter painter;
  EXPECT_EQ(painter.width("\xC3\xA9", 20), painter.width("e", 20));  // e with an accent
  EXPECT_NE(painter.width("×", 20), painter.width("\xEF\xBF\xBD", 20));
  const int replaced = painter.width("\xEF\xBF\xBD", 20);
  EXPECT_EQ(painter.width("\xFF", 20), replaced);
  EXPECT_EQ(painter.width("\xC3", 20), replaced);
  EXPECT_EQ(painter.width("\xF0\x9F\x92", 20), 3 * replaced);
}

}  // namespace ribbon::caption_test
