#include "geometry/segment_triangle.h"

#include <gtest/gtest.h>

namespace ribbon::segment_triangle_test {

using Eigen::Vector3d;

const Vector3d a(0, 0, 0);
const Vector3d b(4, 0, 0);
const Vector3d c(0, 4, 0);

TEST(Pierce, tells_where_the_edge_goes_through) {
  const auto piercing = pierce({1, 1, 3}, {1, 1, -1}, a, b, c).value();
  EXPECT_TRUE(piercing.weights.isApprox(Vector3d(0.5, 0.25, 0.25)));
}

TEST(Pierce, works_from_both_sides) {
  EXPECT_TRUE(pierce({1, 1, -1}, {1, 1, 3}, a, b, c).has_value());
  EXPECT_TRUE(pierce({1, 1, 3}, {1, 1, -1}, a, c, b).has_value());
}

TEST(Pierce, what_goes_through_the_border_goes_through) {
  for (const double from : {1, -1}) {
    EXPECT_TRUE(pierce({2, 0, from}, {2, 0, -from}, a, b, c)
                    .value()
                    .weights.isApprox(Vector3d(0.5, 0.5, 0)));
    EXPECT_TRUE(
        pierce({4, 0, from}, {4, 0, -from}, a, b, c).value().weights.isApprox(Vector3d(0, 1, 0)));
  }
}

TEST(Pierce, an_edge_beside_short_of_or_along_the_triangle_does_not) {
  EXPECT_FALSE(pierce({3, 3, 1}, {3, 3, -1}, a, b, c).has_value());
  EXPECT_FALSE(pierce({1, 1, 3}, {1, 1, 0.001}, a, b, c).has_value());
  EXPECT_FALSE(pierce({-1, 1, 0}, {5, 1, 0}, a, b, c).has_value());
}

TEST(Pierce, neighbours_in_one_slanted_plane_do_not_pierce_by_rounding) {
  // A flat grid in a plane along no axis: every edge lies in the plane of every triangle.
  const Vector3d along(0.137, 0.051, 0.023);
  const Vector3d across(-0.011, 0.083, 0.031);
  const auto point = [&](int i, int j) { return Vector3d(0.1 * i * along + 0.1 * j * across); };
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j)
      EXPECT_FALSE(pierce(point(i, j), point(i + 1, j + 1), point(5, 5), point(9, 6), point(6, 9))
                       .has_value());
}

TEST(Pierce, a_shallow_piercing_is_still_found) {
  EXPECT_TRUE(pierce({1, 1, 1e-12}, {1.1, 1, -1e-12}, a, b, c).has_value());
}

}  // namespace ribbon::segment_triangle_test
