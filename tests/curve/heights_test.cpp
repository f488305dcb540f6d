#include "curve/heights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace ribbon::heights_test {

// Is there room at all crossings, and no way too steep?
void expect_room(const WalkProfile& profile, const Heights& heights) {
  ASSERT_EQ(heights.passages.size(), profile.passage_count());
  constexpr double rounding = 1e-12;
  for (const auto& [above, below, share] : profile.crossings)
    EXPECT_GE(heights.passages[above] - heights.passages[below], share * heights.gap - rounding);
  for (const ObjectBound& bound : profile.bounds) {
    const double sign = bound.in_front ? 1 : -1;
    EXPECT_GE(sign * (heights.passages[bound.passage] - bound.height), heights.gap / 2 - rounding);
  }
  double before = 0;
  for (std::size_t i = 0; i < profile.rises.size(); ++i) {
    const double here = i < heights.passages.size() ? heights.passages[i] : 0;
    EXPECT_LE(std::abs(here - before), profile.rises[i] + rounding) << "way " << i;
    before = here;
  }
}

TEST(Heights, a_walk_without_passages_has_none) {
  EXPECT_TRUE(passage_heights({{5}, {}}, 1).passages.empty());
}

TEST(Heights, passages_with_room_run_on_two_levels) {
  const WalkProfile trefoil{{9, 2, 2, 9, 2, 2, 9}, {{0, 3}, {4, 1}, {2, 5}}};
  const Heights heights = passage_heights(trefoil, 2);
  EXPECT_EQ(heights.passages, (std::vector<double>{1, -1, 1, -1, 1, -1}));
  EXPECT_EQ(heights.gap, 2);
  EXPECT_FALSE(heights.tight.has_value());
}

TEST(Heights, a_passage_near_an_end_stays_low_and_the_others_make_room) {
  const WalkProfile near_start{{0.1, 9, 9, 9, 9, 9, 9}, {{0, 3}, {4, 1}, {2, 5}}};
  const Heights heights = passage_heights(near_start, 2);
  expect_room(near_start, heights);
  EXPECT_EQ(heights.gap, 2);
  EXPECT_FALSE(heights.tight.has_value());
}

// A coil of three turns, each over the one before: three strands lie above one another.
TEST(Heights, strands_that_stack_lie_on_more_than_two_levels) {
  const WalkProfile coil{{9, 0.9, 9, 9, 9, 0.9, 9}, {{2, 0}, {4, 1}, {5, 3}}};
  const Heights heights = passage_heights(coil, 2);
  expect_room(coil, heights);
  EXPECT_FALSE(heights.tight.has_value());
}

TEST(Heights, a_small_loop_is_the_tight_circle) {
  const WalkProfile loop{{9, 0.5, 9}, {{0, 1}}};
  const Heights heights = passage_heights(loop, 2);
  expect_room(loop, heights);
  ASSERT_TRUE(heights.tight.has_value());
  EXPECT_EQ(heights.tight->crossings, 1);
  ASSERT_EQ(heights.tight->stretches.size(), 1U);
  EXPECT_EQ(heights.tight->stretches[0].from, 1U);
  EXPECT_EQ(heights.tight->stretches[0].to, 1U);
  EXPECT_DOUBLE_EQ(heights.tight->gap(), 0.5);
  EXPECT_NEAR(heights.gap, 0.5, 0.001);
  EXPECT_FALSE(passage_heights(loop, 0.499).tight.has_value());
  EXPECT_TRUE(passage_heights(loop, 0.501).tight.has_value());
}

TEST(Heights, a_crossing_that_needs_less_of_the_gap_gets_less) {
  const WalkProfile trefoil{{9, 2, 2, 9, 2, 2, 9}, {{0, 3}, {4, 1, 0.5}, {2, 5}}};
  const Heights heights = passage_heights(trefoil, 2);
  EXPECT_EQ(heights.passages, (std::vector<double>{1, -0.5, 1, -1, 0.5, -1}));
  const WalkProfile loop{{9, 0.5, 9}, {{0, 1, 0.25}}};
  EXPECT_FALSE(passage_heights(loop, 1.9).tight.has_value());
  ASSERT_TRUE(passage_heights(loop, 2.1).tight.has_value());
  EXPECT_DOUBLE_EQ(passage_heights(loop, 2.1).tight->gap(), 2);
  expect_room(loop, passage_heights(loop, 2.1));
}

TEST(Heights, stretches_on_both_sides_of_the_walks_ends_are_two) {
  // Both ends come from the plane; between them one passes over the other.
  const WalkProfile short_ends{{0.5, 9, 0.25}, {{0, 1}}};
  const Heights heights = passage_heights(short_ends, 2);
  expect_room(short_ends, heights);
  ASSERT_TRUE(heights.tight.has_value());
  EXPECT_EQ(heights.tight->stretches.size(), 2U);
  EXPECT_DOUBLE_EQ(heights.tight->gap(), 0.75);
}

TEST(Heights, passages_of_the_object_keep_half_a_gap_from_it) {
  const WalkProfile wrap{{9, 9, 9, 9, 9}, {}, {{0, 3, true}, {1, 3, true}, {2, -1, false}}};
  const Heights heights = passage_heights(wrap, 2);
  expect_room(wrap, heights);
  EXPECT_FALSE(heights.tight.has_value());
}

TEST(Heights, before_the_object_none_is_farther_from_the_plane_than_need_be) {
  // The second passage before the object lies over the first one: 3 + 1 and 2 more.
  const WalkProfile stack{{9, 9, 9, 9, 9}, {{1, 0}}, {{0, 3, true}, {1, 3, true}, {3, 3, true}}};
  const Heights heights = passage_heights(stack, 2);
  expect_room(stack, heights);
  for (const double height : heights.passages) EXPECT_LE(std::abs(height), 6 + 1e-3);
}

TEST(Heights, a_turn_round_the_object_that_is_too_short_is_the_tight_circle) {
  // From 3 + 1 above to 1 + 1 below.
  const WalkProfile wrap{{9, 5, 9}, {}, {{0, 3, true}, {1, -1, false}}};
  const Heights heights = passage_heights(wrap, 2);
  expect_room(wrap, heights);
  ASSERT_TRUE(heights.tight.has_value());
  EXPECT_EQ(heights.tight->bounds, 2U);
  EXPECT_DOUBLE_EQ(heights.tight->object, 4);
  EXPECT_DOUBLE_EQ(heights.tight->gap(), 1);
  EXPECT_FALSE(passage_heights(wrap, 0.999).tight.has_value());
}

TEST(Heights, an_object_too_high_for_any_gap_leaves_none) {
  const Heights heights = passage_heights({{9, 3, 9}, {}, {{0, 3, true}, {1, -1, false}}}, 2);
  EXPECT_TRUE(heights.passages.empty());
  ASSERT_TRUE(heights.tight.has_value());
  EXPECT_LT(heights.gap, 0);
}

TEST(Heights, the_tight_circle_accounts_for_the_gap_whatever_the_drawing) {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  int tight = 0;
  for (int drawing = 0; drawing < 200; ++drawing) {
    const std::size_t crossings = 1 + random() % 12;
    std::vector<std::size_t> order(2 * crossings);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), random);
    WalkProfile profile;
    for (std::size_t i = 0; i < crossings; ++i)
      profile.crossings.push_back({order[2 * i], order[2 * i + 1]});
    for (std::size_t i = 0; i <= 2 * crossings; ++i) profile.rises.push_back(between(0.1, 2));
    const Heights heights = passage_heights(profile, 1);
    expect_room(profile, heights);
    if (!heights.tight) {
      EXPECT_EQ(heights.gap, 1);
      continue;
    }
    ++tight;
    double rise = 0;
    for (const Stretch& stretch : heights.tight->stretches)
      for (std::size_t way = stretch.from; way <= stretch.to; ++way) rise += profile.rises[way];
    EXPECT_NEAR(rise / heights.tight->crossings, heights.gap, 0.002);
  }
  EXPECT_GT(tight, 50);
  EXPECT_LT(tight, 200);
}

}  // namespace ribbon::heights_test
