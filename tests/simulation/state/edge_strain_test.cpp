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

}  // namespace ribbon::edge_strain_test
