#include "geometry/closest_points.h"

#include <gtest/gtest.h>

#include <random>

namespace ribbon::closest_points_test {

using Eigen::Vector2d;
using Eigen::Vector3d;

const Vector3d a(0, 0, 0);
const Vector3d b(2, 0, 0);
const Vector3d c(0, 2, 0);

TEST(ClosestOnTriangle, above_the_inside_it_is_the_foot_of_the_perpendicular) {
  EXPECT_TRUE(closest_on_triangle({0.5, 0.5, 3}, a, b, c).isApprox(Vector3d(0.5, 0.25, 0.25)));
}

TEST(ClosestOnTriangle, beyond_an_edge_it_lies_on_the_edge_and_beyond_a_corner_on_the_corner) {
  EXPECT_TRUE(closest_on_triangle({1, -5, 1}, a, b, c).isApprox(Vector3d(0.5, 0.5, 0)));
  EXPECT_TRUE(closest_on_triangle({9, -1, 0}, a, b, c).isApprox(Vector3d(0, 1, 0)));
  EXPECT_TRUE(closest_on_triangle({-3, 1, 1}, a, b, c).isApprox(Vector3d(0.5, 0, 0.5)));
  EXPECT_TRUE(closest_on_triangle({3, 3, 0}, a, b, c).isApprox(Vector3d(0, 0.5, 0.5)));
}

TEST(ClosestOnTriangle, a_degenerate_triangle_is_its_longest_edge) {
  const Vector3d weights = closest_on_triangle({1.5, 1, 0}, a, {1, 0, 0}, b);
  const Vector3d point = weights[1] * Vector3d(1, 0, 0) + weights[2] * b;
  EXPECT_TRUE(point.isApprox(Vector3d(1.5, 0, 0)));
}

// Three points of one line up to rounding, which must not decide where the foot lies.
TEST(ClosestOnTriangle, of_a_needle_no_point_of_its_border_is_closer) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&] {
    return Vector3d(coordinate(random), coordinate(random), coordinate(random));
  };
  for (int trial = 0; trial < 1000; ++trial) {
    const Vector3d from = point();
    const Vector3d to = point();
    const Vector3d between = from + 0.3 * (to - from);
    const Vector3d p = point();
    const Vector3d weights = closest_on_triangle(p, from, between, to);
    const double found = (weights[0] * from + weights[1] * between + weights[2] * to - p).norm();
    for (int i = 0; i <= 20; ++i)
      EXPECT_GE((from + i / 20.0 * (to - from) - p).norm(), found - 1e-9) << trial;
  }
}

TEST(ClosestOnSegments, a_segment_without_length_is_its_point) {
  const Vector3d beside(0.5, 3, 0);
  EXPECT_EQ(closest_on_segments(a, b, beside, beside)[0], 0.25);
  EXPECT_EQ(closest_on_segments(beside, beside, a, b)[1], 0.25);
  const Vector3d beyond(9, 3, 0);
  EXPECT_EQ(closest_on_segments(beyond, beyond, a, b)[1], 1);
  EXPECT_FALSE(closest_on_segments(beyond, beyond, a, b).hasNaN());
}

TEST(ClosestOnSegments, of_crossing_lines_it_is_the_common_perpendicular) {
  EXPECT_TRUE(closest_on_segments({-1, 0, 0}, {1, 0, 0}, {0, -1, 1}, {0, 3, 1})
                  .isApprox(Vector2d(0.5, 0.25)));
}

TEST(ClosestOnSegments, no_other_pair_of_points_is_closer) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&] {
    return Vector3d(coordinate(random), coordinate(random), coordinate(random));
  };
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3d p0 = point();
    const Vector3d p1 = point();
    const Vector3d q0 = point();
    const Vector3d q1 = trial % 4 == 0 ? Vector3d(q0 + (p1 - p0)) : point();  // some are parallel
    const Vector2d st = closest_on_segments(p0, p1, q0, q1);
    EXPECT_TRUE((st.array() >= 0).all() && (st.array() <= 1).all()) << trial;
    const double found = (p0 + st[0] * (p1 - p0) - q0 - st[1] * (q1 - q0)).norm();
    for (int i = 0; i <= 20; ++i)
      for (int j = 0; j <= 20; ++j)
        EXPECT_GE((p0 + i / 20.0 * (p1 - p0) - q0 - j / 20.0 * (q1 - q0)).norm(), found - 1e-12);
  }
}

}  // namespace ribbon::closest_points_test
