#include "commandline/frame_range.h"

#include <gtest/gtest.h>

namespace ribbon::frame_range_test {

using Indices = std::vector<int>;

Indices of_ten(const std::string& text) {
  return parse_frame_range(text, 10).value();
}

std::string complaint(const std::string& text, int frame_count = 10) {
  const auto range = parse_frame_range(text, frame_count);
  return range ? "" : range.error().sentence();
}

TEST(FrameRange, empty_text_is_all_frames) {
  EXPECT_EQ(of_ten(""), (Indices{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(of_ten(":"), of_ten(""));
  EXPECT_EQ(of_ten("::"), of_ten(""));
}

TEST(FrameRange, one_number_is_one_frame) {
  EXPECT_EQ(of_ten("1"), Indices{0});
  EXPECT_EQ(of_ten("10"), Indices{9});
}

TEST(FrameRange, both_ends_are_included) {
  EXPECT_EQ(of_ten("3:5"), (Indices{2, 3, 4}));
}

TEST(FrameRange, a_step_leaves_frames_out) {
  EXPECT_EQ(of_ten("1:10:4"), (Indices{0, 4, 8}));
  EXPECT_EQ(of_ten("2:9:2147483647"), Indices{1});
}

TEST(FrameRange, an_end_left_out_is_the_recordings_end) {
  EXPECT_EQ(of_ten("8:"), (Indices{7, 8, 9}));
  EXPECT_EQ(of_ten(":2"), (Indices{0, 1}));
  EXPECT_EQ(of_ten("::5"), (Indices{0, 5}));
}

TEST(FrameRange, negative_numbers_count_from_the_end) {
  EXPECT_EQ(of_ten("-1"), Indices{9});
  EXPECT_EQ(of_ten("-3:"), (Indices{7, 8, 9}));
  EXPECT_EQ(of_ten(":-9"), (Indices{0, 1}));
}

TEST(FrameRange, a_negative_step_runs_backwards) {
  EXPECT_EQ(of_ten("5:2:-1"), (Indices{4, 3, 2, 1}));
  EXPECT_EQ(of_ten("::-4"), (Indices{9, 5, 1}));
  EXPECT_EQ(of_ten("3::-2"), (Indices{2, 0}));
  EXPECT_EQ(of_ten("2:1:-2147483648"), Indices{1});
}

TEST(FrameRange, a_list_has_commas_between_and_keeps_its_order) {
  EXPECT_EQ(of_ten("1,5,8:10"), (Indices{0, 4, 7, 8, 9}));
  EXPECT_EQ(of_ten("-1,3:1:-1"), (Indices{9, 2, 1, 0}));
}

TEST(FrameRange, a_frame_that_is_named_again_comes_once) {
  EXPECT_EQ(of_ten("4,2:5,4,1"), (Indices{3, 1, 2, 4, 0}));
}

TEST(FrameRange, a_list_with_nothing_between_two_commas_is_an_error) {
  for (const char* text : {",", "1,", ",1", "1,,2"})
    EXPECT_EQ(complaint(text), "frames '" + std::string(text) +
                                   "': have nothing between two commas; write numbers and ranges: "
                                   "1,5,9:20");
  EXPECT_NE(complaint("1,11"), "");
}

TEST(FrameRange, frames_that_are_not_there_are_an_error) {
  EXPECT_EQ(complaint("11"),
            "frames '11': name frame 11 of a recording with 10 frames; "
            "write numbers from 1 to 10, or -1 for the last");
  EXPECT_NE(complaint("0"), "");
  EXPECT_NE(complaint("-11"), "");
  EXPECT_NE(complaint("5:11"), "");
  EXPECT_NE(complaint("-2147483648"), "");
}

TEST(FrameRange, the_wrong_direction_is_an_error) {
  EXPECT_EQ(complaint("5:2"),
            "frames '5:2': run backwards; write a negative step, or the smaller number first");
  EXPECT_EQ(complaint("2:5:-1"),
            "frames '2:5:-1': run forwards; write a positive step, or the larger number first");
}

TEST(FrameRange, a_step_of_zero_is_an_error) {
  EXPECT_NE(complaint("1:5:0"), "");
}

TEST(FrameRange, what_is_no_range_is_an_error) {
  for (const char* text : {"a", "1:b", "1:2:c", "1:2:3:4", "1.5", " 1", "1 ", "+1", "1-5", "0x1",
                           "99999999999", "1:5:99999999999", "-"})
    EXPECT_NE(complaint(text), "") << text;
}

TEST(FrameRange, a_recording_without_frames_has_only_the_empty_range) {
  EXPECT_EQ(parse_frame_range("", 0).value(), Indices{});
  EXPECT_EQ(parse_frame_range("::2", 0).value(), Indices{});
  EXPECT_NE(complaint("1", 0), "");
  EXPECT_NE(complaint("-1:", 0), "");
}

}  // namespace ribbon::frame_range_test
