#include "commandline/frame_pattern.h"

#include <gtest/gtest.h>

#include "result/refusal.h"

namespace ribbon::frame_pattern_test {

std::string file(const std::string& pattern, int number) {
  return FramePattern::parse(pattern).value().file(number).string();
}

TEST(FramePattern, the_number_stands_where_the_pattern_says) {
  EXPECT_EQ(file("out/knot.{frame:04}.obj", 7), "out/knot.0007.obj");
  EXPECT_EQ(file("{frame:02}", 7), "07");
  EXPECT_EQ(file("frame{frame:01}/knot.png", 7), "frame7/knot.png");
}

TEST(FramePattern, four_digits_unless_told_otherwise) {
  EXPECT_EQ(file("{frame}.png", 7), "0007.png");
}

TEST(FramePattern, a_number_too_long_for_its_width_is_not_cut) {
  EXPECT_EQ(file("{frame:02}", 12345), "12345");
  EXPECT_EQ(file("{frame:09}", 2147483647), "2147483647");
}

TEST(FramePattern, other_braces_are_left_alone) {
  EXPECT_EQ(file("{a}/{frame:02}}.png", 7), "{a}/07}.png");
}

TEST(FramePattern, a_missing_place_is_an_error) {
  for (const std::string text : {"", "out.obj", "{fram:04}", "frame:04"})
    EXPECT_EQ(refusal_of(FramePattern::parse(text)),
              "'" + text +
                  "' has no place for the frame number; "
                  "write '{frame:04}' where the number shall stand");
}

TEST(FramePattern, one_frame_needs_no_place_and_two_do) {
  EXPECT_EQ(FramePattern::parse("knot.obj", 1)->file(7), "knot.obj");
  EXPECT_EQ(FramePattern::parse("knot.{frame:04}.obj", 1)->file(7), "knot.0007.obj");
  EXPECT_FALSE(FramePattern::parse("knot.{fram}.obj", 1).has_value());
  EXPECT_FALSE(FramePattern::parse("knot.obj", 2).has_value());
}

TEST(FramePattern, two_places_are_an_error) {
  EXPECT_FALSE(FramePattern::parse("{frame}/{frame:04}.obj").has_value());
}

TEST(FramePattern, malformed_places_are_an_error) {
  for (const char* text :
       {"{frame", "{frame:04", "{frame:}", "{frame:0}", "{frame:00}", "{frame:4}", "{frame:010}",
        "{frame:-4}", "{frame:0x}", "{frames}", "{frame:04d}"})
    EXPECT_FALSE(FramePattern::parse(text).has_value()) << text;
}

TEST(FramePattern, a_word_may_stand_in_the_place_of_the_number) {
  EXPECT_EQ(FramePattern::parse("out/knot.{frame:04}.png")->file("list"), "out/knot.list.png");
  EXPECT_EQ(FramePattern::parse("last.png", 1)->file("list"), "last.png.list");
}

}  // namespace ribbon::frame_pattern_test
