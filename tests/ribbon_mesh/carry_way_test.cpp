#include "ribbon_mesh/carry_way.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace ribbon::carry_way_test {

using Eigen::Matrix3Xd;
using Eigen::Vector2d;
using Eigen::Vector3d;

// 3 units to the right and 1 down; the page's (10, 20) lies on the world's origin.
Matrix3Xd way_of(std::vector<HeightAt> heights, Axis axis = Axis::y) {
  CurveScene curve;
  curve.unit_m = 0.5;
  curve.origin = {10, 20};
  curve.axis = axis;
  return carry_way(curve,
                   {std::vector<Vector2d>{{10, 20}, {13, 20}, {13, 21}}, std::move(heights)});
}

Matrix3Xd columns(const std::vector<Vector3d>& points) {
  Matrix3Xd matrix(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    matrix.col(static_cast<Eigen::Index>(i)) = points[i];
  return matrix;
}

TEST(CarryWay, lies_in_the_world_as_the_curve_does) {
  EXPECT_EQ(way_of({{0, 7}}), columns({{0, 7, 0}, {1.5, 7, 0}, {1.5, 7, 0.5}}));
  EXPECT_EQ(way_of({{0, 7}}, Axis::z), columns({{0, 0, 7}, {1.5, 0, 7}, {1.5, -0.5, 7}}));
  EXPECT_EQ(way_of({{0, 7}}, Axis::x), columns({{7, 0, 0}, {7, 0, -1.5}, {7, -0.5, -1.5}}));
}

TEST(CarryWay, has_corners_where_its_heights_have) {
  EXPECT_EQ(way_of({{0, 0}, {0.5, 8}, {1, 4}}),
            columns({{0, 0, 0}, {1, 8, 0}, {1.5, 6, 0}, {1.5, 4, 0.5}}));
}

TEST(CarryWay, of_points_that_are_all_the_same_is_one_place) {
  CurveScene curve;
  const Matrix3Xd way = carry_way(curve, {std::vector<Vector2d>{{1000, 0}, {1000, 0}}, {{0, 2}}});
  EXPECT_TRUE(way.isApprox(Vector3d(1, 2, 0).replicate(1, way.cols())));
}

}  // namespace ribbon::carry_way_test
