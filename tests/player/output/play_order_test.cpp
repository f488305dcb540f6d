#include "player/output/play_order.h"

#include <gtest/gtest.h>

#include "result/refusal.h"

namespace ribbon::play_order_test {

using Numbers = std::vector<int>;

Numbers indices(const std::vector<PlayedFrame>& frames) {
  Numbers indices;
  for (const PlayedFrame& frame : frames) indices.push_back(frame.index);
  return indices;
}

Numbers numbers(const std::vector<PlayedFrame>& frames) {
  Numbers numbers;
  for (const PlayedFrame& frame : frames) numbers.push_back(frame.number);
  return numbers;
}

std::vector<PlayedFrame> played(Numbers frames, const PlayOrder& order) {
  return played_frames(std::move(frames), 50, order).value();
}

TEST(PlayOrder, pictures_have_the_numbers_of_their_frames) {
  EXPECT_EQ(indices(played({2, 7, 4}, {})), (Numbers{2, 7, 4}));
  EXPECT_EQ(numbers(played({2, 7, 4}, {})), (Numbers{3, 8, 5}));
}

TEST(PlayOrder, another_order_counts_its_pictures) {
  const auto frames = played({2, 4, 7}, {.reverse = true});
  EXPECT_EQ(indices(frames), (Numbers{7, 4, 2}));
  EXPECT_EQ(numbers(frames), (Numbers{1, 2, 3}));
}

TEST(PlayOrder, there_and_back_doubles_neither_end) {
  EXPECT_EQ(indices(played({0, 1, 2, 3}, {.ping_pong = true})), (Numbers{0, 1, 2, 3, 2, 1}));
  EXPECT_EQ(indices(played({0, 1}, {.ping_pong = true})), (Numbers{0, 1}));
  EXPECT_EQ(indices(played({5}, {.ping_pong = true})), Numbers{5});
  EXPECT_EQ(indices(played({0, 1, 2}, {.reverse = true, .ping_pong = true})),
            (Numbers{2, 1, 0, 1}));
}

TEST(PlayOrder, progress_runs_from_0_to_below_1) {
  const auto frames = played({0, 1, 2, 3}, {});
  EXPECT_EQ(frames.front().progress, 0);
  EXPECT_EQ(frames.back().progress, 0.75);
}

TEST(Hold, a_frame_stands_for_so_many_pictures_or_seconds) {
  EXPECT_EQ(indices(played({7}, {.hold = Hold{3}})), (Numbers{7, 7, 7}));
  EXPECT_EQ(numbers(played({7}, {.hold = Hold{3}})), (Numbers{1, 2, 3}));
  EXPECT_EQ(played({7}, {.hold = Hold{4, true}}).size(), 200U) << "recorded at 50 a second";
  EXPECT_EQ(played({7}, {.frames_per_second = 24, .hold = Hold{4, true}}).size(), 96U);
  EXPECT_EQ(played({7}, {.hold = Hold{1e-6, true}}).size(), 1U);
}

TEST(Hold, goes_with_every_order) {
  EXPECT_EQ(indices(played({0, 1, 2}, {.reverse = true, .hold = Hold{2}})),
            (Numbers{2, 2, 1, 1, 0, 0}));
  EXPECT_EQ(indices(played({0, 1, 2}, {.ping_pong = true, .hold = Hold{2}})),
            (Numbers{0, 0, 1, 1, 2, 2, 1, 1}));
  EXPECT_EQ(indices(played({0, 1, 2}, {.frames_per_second = 25, .hold = Hold{1}})),
            (Numbers{0, 1, 2}))
      << "each frame once, at another pace";
}

TEST(Hold, is_read_as_pictures_or_seconds) {
  EXPECT_EQ(parse_hold("24").value(), (Hold{24, false}));
  EXPECT_EQ(parse_hold("1.5s").value(), (Hold{1.5, true}));
  for (const char* text : {"", "s", "0", "0s", "-2", "1.5", "2 s", "2m", "infs", "nan", "2ss"})
    EXPECT_THAT(refusal_of(parse_hold(text)), HasSubstr("as in 96 or 4s")) << text;
  EXPECT_THAT(refusal_of(played_frames({0, 1}, 50, {.hold = Hold{1e9}})),
              HasSubstr("--hold 1e+09: makes 2e+09 pictures of 2 frames"));
}

// Recorded at 50 a second.
TEST(Resampling, takes_the_nearest_frame_of_each_moment) {
  EXPECT_EQ(indices(played({0, 1, 2, 3, 4}, {.frames_per_second = 25})), (Numbers{0, 2, 4}));
  EXPECT_EQ(indices(played({0, 1, 2, 3}, {.frames_per_second = 75})), (Numbers{0, 1, 1, 2, 3}));
  EXPECT_EQ(indices(played({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, {.frames_per_second = 15})),
            (Numbers{0, 3, 7, 10}));
}

TEST(Resampling, to_the_same_rate_changes_nothing) {
  EXPECT_EQ(indices(played({0, 1, 2}, {.frames_per_second = 50})), (Numbers{0, 1, 2}));
}

TEST(Resampling, keeps_the_last_moment_whatever_rounding_does) {
  Numbers all(301);
  for (int i = 0; i < 301; ++i) all[static_cast<std::size_t>(i)] = i;
  for (const double rate : {10.0, 30.0, 60.0, 29.97, 23.976}) {
    const auto frames = played(all, {.frames_per_second = rate});
    EXPECT_NEAR(static_cast<double>(frames.size()), 6 * rate + 1, 1) << rate;
    EXPECT_GE(frames.back().index, 300 - 50 / rate) << rate;
  }
}

TEST(Resampling, absurd_numbers_of_pictures_are_refused) {
  EXPECT_THAT(refusal_of(played_frames({0, 1, 2}, 1e-9, {.frames_per_second = 1e4})),
              HasSubstr("makes 2e+13 pictures of 3 frames"));
}

std::vector<double> shown(Numbers frames, const PlayOrder& order) {
  std::vector<double> shown;
  for (const PlayedFrame& frame : played(std::move(frames), order)) shown.push_back(frame.frame());
  return shown;
}

// Recorded at 50 a second.
TEST(Interpolation, shows_what_lies_between_frames_and_frames_themselves_where_they_are) {
  EXPECT_EQ(shown({0, 1, 2}, {.frames_per_second = 100, .interpolates = true}),
            (std::vector<double>{1, 1.5, 2, 2.5, 3}));
  EXPECT_EQ(shown({0, 1, 2, 3}, {.frames_per_second = 40, .interpolates = true}),
            (std::vector<double>{1, 2.25, 3.5}));
  Numbers all(301);
  for (int i = 0; i < 301; ++i) all[static_cast<std::size_t>(i)] = i;
  int recorded = 0;
  for (const PlayedFrame& frame : played(all, {.frames_per_second = 150, .interpolates = true}))
    recorded += frame.is_interpolated() ? 0 : 1;
  EXPECT_EQ(recorded, 301) << "whatever rounding does";
}

TEST(Interpolation, goes_through_the_recording_also_where_frames_were_left_out_or_backwards) {
  EXPECT_EQ(shown({0, 10}, {.frames_per_second = 200, .interpolates = true}),
            (std::vector<double>{1, 3.5, 6, 8.5, 11}));
  EXPECT_EQ(shown({0, 1, 2}, {.reverse = true, .frames_per_second = 100, .interpolates = true}),
            (std::vector<double>{3, 2.5, 2, 1.5, 1}));
}

TEST(Interpolation, needs_both_frames) {
  const auto all = played({0, 1, 2}, {.frames_per_second = 100, .interpolates = true});
  EXPECT_EQ(numbers(without(all, {2})), (Numbers{1, 2, 3}));
  const auto held = held_over(all, {2});
  EXPECT_EQ(held[3].frame(), 2);
  EXPECT_EQ(held[4].frame(), 2);
}

TEST(Shards, cover_everything_once) {
  const auto all = played({0, 1, 2, 3, 4, 5, 6}, {});
  EXPECT_EQ(indices(part_of(all, {1, 3})), (Numbers{0, 3, 6}));
  EXPECT_EQ(indices(part_of(all, {2, 3})), (Numbers{1, 4}));
  EXPECT_EQ(indices(part_of(all, {3, 3})), (Numbers{2, 5}));
  EXPECT_EQ(indices(part_of(all, {})), indices(all));
  EXPECT_TRUE(part_of(all, {9, 9}).empty());
}

TEST(Shards, are_read_as_part_of_so_many) {
  EXPECT_EQ(parse_shard("2/8")->part, 2);
  EXPECT_EQ(parse_shard("2/8")->parts, 8);
  for (const char* text : {"", "2", "/", "2/", "/8", "0/8", "9/8", "-1/8", "2/8/1", "2 /8", "a/b"})
    EXPECT_THAT(refusal_of(parse_shard(text)), HasSubstr("is no part of a job")) << text;
}

TEST(LostFrames, are_left_out_or_the_one_before_is_held) {
  const auto all = played({0, 1, 2, 3}, {});
  EXPECT_EQ(numbers(without(all, {0, 2})), (Numbers{2, 4}));
  EXPECT_EQ(indices(held_over(all, {0, 2})), (Numbers{1, 1, 1, 3}));
  EXPECT_EQ(numbers(held_over(all, {0, 2})), (Numbers{1, 2, 3, 4}));
  EXPECT_TRUE(held_over(all, {0, 1, 2, 3}).empty());
}

}  // namespace ribbon::play_order_test
