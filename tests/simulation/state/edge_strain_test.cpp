#include "simulation/state/edge_strain.h"

#include <gtest/gtest.h>

namespace ribbon::edge_strain_test {

using Eigen::Matrix3Xd;

// By hand, of edges of 0.5 m along and 1 m across: row 1 lies 0.6 m instead of 0.5 from row 0; its
// last particle 0.7 m instead of 1 m from its neighbour, which shortens its one diagonal from sqrt
// 1.25 m to sqrt 0.85 m, by 17.5 %.
TEST(WorstStrain, is_of_those_springs_that_the_scene_has_and_of_shrinking_too) {
  Matrix3Xd x(3, 6);
  x << 0, 0, 0, 0.6, 0.6, 0.6, 0, 1, 2, 0, 1, 1.7, 0, 0, 0, 0, 0, 0;
  const auto worst = [&](const SpringScene& stiffness) {
    return worst_strain(spring_network({{2, 3}, 0.5, 2}, stiffness), x);
  };
  EXPECT_NEAR(worst({.stretch = 1, .shear = 1}), 0.3416, 1e-4);
  EXPECT_NEAR(worst({.shear = 1}), 0.1754, 1e-4);
  EXPECT_EQ(worst({.bend = 1}), 0);
}

TEST(EdgeStrain, is_above_zero_where_an_edge_is_stretched_and_below_where_it_has_shrunk) {
  Matrix3Xd x(3, 2);
  x << 0, 0, 0, 3, 0, 4;
  EXPECT_DOUBLE_EQ(edge_strain({1, 0, 4}, 0, 1, x), 0.25);
  EXPECT_DOUBLE_EQ(edge_strain({1, 0, 8}, 1, 0, x), -0.375);
}

// By hand, of two edges along of 0.5 and 1.2 m, whose ends part at 3 and 4 m/s.
TEST(EdgeStrain, changes_by_how_differently_neighbours_along_the_ribbon_move) {
  Matrix3Xd x(3, 4);
  x << 0, 0, 0.5, 1.2, 0, 9, 0, 9, 0, 0, 0, 0;
  Matrix3Xd v = Matrix3Xd::Constant(3, 4, 100);
  v.col(2) += Eigen::Vector3d(0, 3, 0);
  v.col(3) += Eigen::Vector3d(0, 0, -4);
  EXPECT_DOUBLE_EQ(change_per_s({2, 2}, x, v), 5 / 1.3);
  EXPECT_EQ(change_per_s({2, 2}, x, Matrix3Xd::Constant(3, 4, 100)), 0);
}

}  // namespace ribbon::edge_strain_test
