#include "model/point_bounds.h"

#include <gtest/gtest.h>

namespace ribbon::point_bounds_test {

Eigen::Matrix3Xf points_on_a_diagonal(Eigen::Index count) {
  Eigen::Matrix3Xf points(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    points.col(i) = Eigen::Vector3f(1, -1, 2) * static_cast<float>(i);
  return points;
}

TEST(PointBounds, nothing_reaches_nowhere) {
  EXPECT_EQ(bounds_of(Eigen::Matrix3Xf(3, 0)).least, Eigen::Vector3f::Zero());
  EXPECT_EQ(bounds_of(Eigen::Matrix3Xf(3, 0)).largest, Eigen::Vector3f::Zero());
}

TEST(PointBounds, each_place_among_the_points_counts) {
  for (Eigen::Index count = 1; count <= 13; ++count)
    for (Eigen::Index farthest = 0; farthest < count; ++farthest) {
      Eigen::Matrix3Xf points = points_on_a_diagonal(count);
      points.col(farthest) << 100, 200, 300;
      EXPECT_EQ(bounds_of(points).largest, Eigen::Vector3f(100, 200, 300)) << count;
      points.col(farthest) << -300, -200, -100;
      EXPECT_EQ(bounds_of(points).least, Eigen::Vector3f(-300, -200, -100)) << count;
    }
}

}  // namespace ribbon::point_bounds_test
