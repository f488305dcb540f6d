#include "simulation/start/first_intersection.h"

#include <gtest/gtest.h>

#include "simulation/published/planted_penetrations.h"

namespace ribbon::first_intersection_test {

using Eigen::Matrix3Xd;

TEST(FirstIntersection, a_free_ribbon_has_none) {
  auto [grid, positions, bodies] = folded(0.5);
  EXPECT_FALSE(first_intersection(bodies, positions).has_value());
  EXPECT_FALSE(first_closer_than(0.2, bodies, positions).has_value());
}

TEST(FirstIntersection, of_two_layers_names_a_particle_of_each) {
  auto [grid, positions, bodies] = folded(0.5);
  positions(1, grid.particle(15, 2)) = -0.2;
  const auto at = first_intersection(bodies, positions).value();
  // Row 15 lies over x = 20 - 15 - 0.5 = 4.5, between rows 4 and 5.
  EXPECT_NEAR(grid.row(at.particle), 4.5, 1.6);
  EXPECT_NEAR(grid.row(at.other), 15, 1.1);
}

TEST(FirstIntersection, closer_than_the_gap_is_found_and_at_the_gap_is_not) {
  const RibbonGrid grid{7, 5};
  OverFloor planted = ribbon_over_floor(grid, -0.25);
  EXPECT_FALSE(first_closer_than(0.25, planted.bodies, planted.positions).has_value());
  const auto at = first_closer_than(0.2501, planted.bodies, planted.positions).value();
  EXPECT_LT(at.particle, grid.particle_count());
  EXPECT_GE(at.other, grid.particle_count());
}

TEST(FirstIntersection, of_the_obstacle_s_edge_with_the_ribbon_s_inside_is_found) {
  const RibbonGrid grid{7, 5};
  const OverFloor planted = ribbon_over_floor(grid, -1);
  // The floor's diagonal edge is stood on its end and pricks through a quad.
  Matrix3Xd on_end(3, 4);
  on_end << 2.6, 2.6, 2.6, 2.65, -1, 1, 1, -1, 1.3, 1.3, 1.31, 1.31;
  Bodies bodies{grid, ObstacleBody(planted.bodies.obstacle->surface.triangles, on_end)};
  const auto at = first_intersection(bodies, planted.positions).value();
  EXPECT_GE(at.other, grid.particle_count());
  EXPECT_NEAR(grid.row(at.particle), 2.6, 1);
}

}  // namespace ribbon::first_intersection_test
