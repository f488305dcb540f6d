#include "geometry/box.h"

#include <gtest/gtest.h>

#include <random>

namespace ribbon::box_test {

using Eigen::Vector3d;

MovingBox moving(const Vector3d& start, const Vector3d& end) {
  return {Box::around(start), Box::around(end)};
}

TEST(MovingBox, those_that_fly_beside_each_other_do_not_meet) {
  // As still boxes around all of their ways they would overlap from 1 to 10.
  const MovingBox first = moving({0, 0, 0}, {10, 0, 0});
  const MovingBox second = moving({1, 0, 0}, {11, 0, 0});
  EXPECT_FALSE(first.meets(second));
  EXPECT_FALSE(second.meets(first));
}

TEST(MovingBox, one_that_overtakes_the_other_meets_it) {
  EXPECT_TRUE(moving({0, 0, 0}, {10, 0, 0}).meets(moving({1, 0, 0}, {2, 0, 0})));
}

TEST(MovingBox, those_that_pass_in_different_coordinates_at_the_ends_may_meet_between) {
  // Apart in x at the start and in y at the end, they touch half way.
  EXPECT_TRUE(moving({0, 0, 0}, {0, 0, 0}).meets(moving({1, -1, 0}, {-1, 1, 0})));
}

TEST(MovingBox, a_margin_keeps_apart_what_comes_that_close) {
  MovingBox first = moving({0, 0, 0}, {0, 0, 0});
  const MovingBox second = moving({1, 0, 0}, {0.5, 0, 0});
  EXPECT_FALSE(first.meets(second));
  first.grow(0.6);
  EXPECT_TRUE(first.meets(second));
}

// Whatever meets at some instant is said to meet.
TEST(MovingBox, misses_no_meeting_of_moving_segments) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&] {
    return Vector3d(coordinate(random), coordinate(random), coordinate(random));
  };
  int meetings = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const std::array<Vector3d, 4> start = {point(), point(), point(), point()};
    const std::array<Vector3d, 4> end = {point(), point(), point(), point()};
    const auto box_at = [&](std::size_t a, std::size_t b, double time) {
      Box box = Box::around((1 - time) * start[a] + time * end[a]);
      box.include(Vector3d((1 - time) * start[b] + time * end[b]));
      return box;
    };
    const MovingBox first{box_at(0, 1, 0), box_at(0, 1, 1)};
    const MovingBox second{box_at(2, 3, 0), box_at(2, 3, 1)};
    for (int eighth = 0; eighth <= 8; ++eighth) {
      const double time = eighth / 8.0;
      if (!box_at(0, 1, time).meets(box_at(2, 3, time))) continue;
      ++meetings;
      ASSERT_TRUE(first.meets(second)) << trial;
    }
  }
  EXPECT_GT(meetings, 1000);
}

TEST(PackedBox, touching_boxes_meet_wherever_they_lie) {
  const Vector3d far(3e3, -7e-4, 1.1);
  const Vector3d corner(0.1, 0.2, 0.3);
  for (const Vector3d& at : {Vector3d(0, 0, 0), far}) {
    const MovingBox low{{at, at + corner}, {at, at + corner}};
    const MovingBox high{{at + corner, at + 2 * corner}, {at + corner, at + 2 * corner}};
    EXPECT_TRUE(PackedBox::around(low, 0, {0, 0, 0}).meets(PackedBox::around(high, 0, {0, 0, 0})));
    EXPECT_TRUE(PackedBox::around(low, 0, at).meets(PackedBox::around(high, 0, at)));
  }
}

TEST(PackedBox, of_a_box_that_stays_is_that_of_one_that_moves_nowhere) {
  const Box still{{-1.1, 0.2, 3.3}, {0.7, 0.3, 4.1}};
  const PackedBox packed = PackedBox::around(still, 0.01, {5, 6, 7});
  const PackedBox moving = PackedBox::around(MovingBox{still, still}, 0.01, {5, 6, 7});
  for (const auto lanes :
       {&PackedBox::start_low, &PackedBox::start_high, &PackedBox::end_low, &PackedBox::end_high})
    EXPECT_TRUE(((packed.*lanes) == (moving.*lanes)).all());
}

// Packing may bring boxes together, by some rounding, but never apart.
TEST(PackedBox, misses_no_meeting_and_adds_only_what_nearly_touches) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const Vector3d origin(50, -20, 3);
  const auto box = [&] {
    const Vector3d a(coordinate(random), coordinate(random), coordinate(random));
    const Vector3d b(coordinate(random), coordinate(random), coordinate(random));
    Box result = Box::around(origin + a);
    result.include(Vector3d(origin + a + 0.7 * b));
    return result;
  };
  int meetings = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    const MovingBox first{box(), box()};
    const MovingBox second{box(), box()};
    MovingBox grown = first;
    grown.grow(1e-6);
    const bool packed_meet =
        PackedBox::around(first, 0, origin).meets(PackedBox::around(second, 0, origin));
    if (first.meets(second)) {
      ASSERT_TRUE(packed_meet);
    }
    if (!grown.meets(second)) {
      ASSERT_FALSE(packed_meet);
    }
    meetings += packed_meet ? 1 : 0;
  }
  EXPECT_GT(meetings, 1000);
  EXPECT_LT(meetings, 19'000);
}

}  // namespace ribbon::box_test
