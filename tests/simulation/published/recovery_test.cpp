#include "simulation/published/recovery.h"

#include <gtest/gtest.h>

#include "simulation/published/planted_penetrations.h"

namespace ribbon::recovery_test {

using Eigen::Matrix3Xd;

constexpr RecoverySettings settings{.gap_m = 0.01, .step_m = 0.5};

TEST(Penetration, is_counted_once_per_edge) {
  auto [grid, positions, bodies] = folded(0.5);
  EXPECT_EQ(count_penetrating_edges(bodies, positions), 0);
  // One inner particle goes through: its six or eight edges (diagonals included) pierce, and none
  // other does, whatever number of triangles each pierces.
  positions(1, grid.particle(15, 2)) = -0.2;
  const int count = count_penetrating_edges(bodies, positions);
  EXPECT_GE(count, 4);
  EXPECT_LE(count, 8);
}

TEST(Penetration, of_an_obstacle_corner_into_the_ribbon_counts_too) {
  const RibbonGrid grid{7, 5};
  // A thorn pricks through the middle of one quad without touching an edge of the ribbon.
  Matrix3Xd thorn(3, 3);
  thorn << 2.6, 2.6, 2.65, -1, 0.2, -1, 1.3, 1.35, 1.4;
  Bodies bodies{grid, ObstacleBody(Eigen::Vector3i(0, 1, 2), thorn)};
  EXPECT_EQ(count_penetrating_edges(bodies, flat_ribbon(grid)), 2);
}

TEST(Recovery, without_errors_moves_nothing) {
  auto [grid, positions, bodies] = folded(0.5);
  const RecoveryReport report = recover(bodies, settings, positions);
  EXPECT_EQ(report.iterations, 0);
  EXPECT_EQ(report.penetrating_edges, 0);
  EXPECT_EQ(positions, folded_ribbon(grid, 0.5));
}

TEST(Recovery, removes_what_the_schemes_can_remove_and_says_how_often_they_ran) {
  auto [grid, positions, bodies] = folded(0.5);
  positions(1, grid.particle(15, 2)) = -0.02;
  const RecoveryReport report = recover(bodies, settings, positions);
  EXPECT_EQ(report.penetrating_edges, 0);
  EXPECT_GE(report.iterations, 1);
  EXPECT_EQ(count_penetrating_edges(bodies, positions), 0);
}

TEST(Recovery, from_the_obstacle_brings_the_ribbon_out) {
  const RibbonGrid grid{9, 5};
  OverFloor planted = ribbon_over_floor(grid, -0.5);
  for (int row = 3; row <= 5; ++row)
    for (int column = 1; column <= 3; ++column)
      planted.positions(1, grid.particle(row, column)) = -0.7;
  const RecoveryReport report = recover(planted.bodies, settings, planted.positions);
  EXPECT_EQ(report.penetrating_edges, 0);
  EXPECT_GT(planted.positions.row(1).minCoeff(), -0.5);
}

TEST(Recovery, with_patience_leads_out_of_an_obstacle_layer_by_layer) {
  // A step down of the ribbon through the floor: each application moves one row out, and as many
  // edges pierce as before, until the last row is out.
  const RibbonGrid grid{12, 3};
  OverFloor planted = ribbon_over_floor(grid, -0.5);
  for (int row = 6; row < 12; ++row)
    for (int column = 0; column < 3; ++column)
      planted.positions(1, grid.particle(row, column)) = -0.7;
  Eigen::Matrix3Xd patient = planted.positions;
  EXPECT_GT(recover(planted.bodies, settings, planted.positions).penetrating_edges, 0);
  RecoverySettings with_patience = settings;
  with_patience.patience = 12;
  const RecoveryReport report = recover(planted.bodies, with_patience, patient);
  EXPECT_EQ(report.penetrating_edges, 0);
  EXPECT_GE(report.iterations, 6);
}

TEST(Recovery, never_leaves_more_errors_than_it_found) {
  // Two halves pushed deeply through each other along their whole length: beyond the schemes.
  auto [grid, positions, bodies] = folded(0.3);
  for (int row = 11; row < 21; ++row)
    for (int column = 0; column < 5; ++column)
      positions(1, grid.particle(row, column)) = row % 2 == 0 ? 0.3 : -0.3;
  const int before = count_penetrating_edges(bodies, positions);
  ASSERT_GT(before, 0);
  EXPECT_LE(recover(bodies, settings, positions).penetrating_edges, before);
}

}  // namespace ribbon::recovery_test
