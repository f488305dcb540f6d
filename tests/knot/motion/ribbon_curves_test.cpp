#include "knot/motion/ribbon_curves.h"

#include <gtest/gtest.h>

#include "knot/knotted_curves.h"

namespace ribbon::ribbon_curves_test {

// Particle (i, j) at (i, j, bend of i and j).
Eigen::Matrix3Xf flat_grid(const RibbonGrid& grid) {
  Eigen::Matrix3Xf result(3, grid.particle_count());
  for (int k = 0; k < grid.particle_count(); ++k)
    result.col(k) << static_cast<float>(grid.row(k)), static_cast<float>(grid.column(k)), 0;
  return result;
}

TEST(CentreLine, of_an_odd_number_of_columns_is_the_middle_one) {
  const RibbonGrid grid{3, 5};
  const Eigen::Matrix3Xd line = centre_line(grid, flat_grid(grid));
  ASSERT_EQ(line.cols(), 3);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(line.col(i), Eigen::Vector3d(i, 2, 0));
}

TEST(CentreLine, of_an_even_number_stays_on_the_triangles) {
  const RibbonGrid grid{3, 2};
  Eigen::Matrix3Xf positions = flat_grid(grid);
  // Quad 0 is split by the diagonal from (0, 0) to (1, 1), quad 1 by that from (2, 0) to (1, 1).
  positions.col(grid.particle(0, 0)).z() = 4;
  positions.col(grid.particle(2, 0)).z() = 8;
  const Eigen::Matrix3Xd line = centre_line(grid, positions);
  ASSERT_EQ(line.cols(), 5);
  EXPECT_EQ(line.col(0), Eigen::Vector3d(0, 0.5, 2));
  EXPECT_EQ(line.col(1), Eigen::Vector3d(0.5, 0.5, 2));
  EXPECT_EQ(line.col(2), Eigen::Vector3d(1, 0.5, 0));
  EXPECT_EQ(line.col(3), Eigen::Vector3d(1.5, 0.5, 4));
  EXPECT_EQ(line.col(4), Eigen::Vector3d(2, 0.5, 4));
}

// Beside column 1, towards column 2, and bent on the same diagonals as the triangles.
TEST(RibbonCurves, the_line_beside_the_centre_stays_on_the_triangles) {
  const RibbonGrid grid{3, 3};
  Eigen::Matrix3Xf positions = flat_grid(grid);
  positions.col(grid.particle(1, 2)).z() = 8;  // no corner of the two diagonals
  const Eigen::Matrix3Xd line = ribbon_curves(grid, positions).beside_centre;
  ASSERT_EQ(line.cols(), 5);
  const auto expect_near = [&](Eigen::Index k, const Eigen::Vector3d& expected) {
    EXPECT_NEAR((line.col(k) - expected).norm(), 0, 1e-6) << k;
  };
  expect_near(0, {0, 1.125, 0});
  expect_near(1, {0.875, 1.125, 0});
  expect_near(2, {1, 1.125, 1});
  expect_near(3, {1.125, 1.125, 0});
  expect_near(4, {2, 1.125, 0});
}

TEST(RibbonCurves, are_moved_by_less_than_a_quarter_of_the_last_place) {
  const RibbonGrid grid{50, 7};
  Eigen::Matrix3Xf positions = flat_grid(grid);
  positions.row(0) *= 20;  // the largest coordinate is 980, between 512 and 1024
  const RibbonCurves curves = ribbon_curves(grid, positions);
  const double last_place = 512 / 8388608.0;
  const Eigen::Matrix3Xd moved = curves.centre_line - centre_line(grid, positions);
  EXPECT_LE(moved.cwiseAbs().maxCoeff(), last_place / 4);
  EXPECT_GT(moved.cwiseAbs().minCoeff(), 0);
}

TEST(RibbonCurves, no_four_points_of_a_flat_ribbon_stay_in_one_plane) {
  const RibbonGrid grid{12, 4};
  const Eigen::Matrix3Xd line = ribbon_curves(grid, flat_grid(grid)).centre_line;
  for (Eigen::Index k = 0; k + 3 < line.cols(); ++k)
    EXPECT_NE(orientation(
                  ProjectivePoint::point(line.col(k)), ProjectivePoint::point(line.col(k + 1)),
                  ProjectivePoint::point(line.col(k + 2)), ProjectivePoint::point(line.col(k + 3))),
              0);
}

}  // namespace ribbon::ribbon_curves_test
