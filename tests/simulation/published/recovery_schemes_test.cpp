#include "simulation/published/recovery_schemes.h"

#include <gtest/gtest.h>

#include "simulation/published/planted_penetrations.h"

namespace ribbon::recovery_schemes_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr auto boxes = TriangleBvh::Spare::boxes;

TEST(SchemeA, moves_the_erroneous_particle_out_by_its_depth_and_the_gap) {
  const RibbonGrid grid{7, 5};
  OverFloor planted = ribbon_over_floor(grid, -0.5);
  const int astray = grid.particle(3, 2);
  planted.positions(1, astray) = -0.8;
  Bodies& bodies = planted.bodies;
  const auto found =
      mutual_penetrations(bodies.ribbon.surface(), bodies.ribbon.triangle_bvh(planted.positions),
                          *bodies.obstacle, planted.positions);
  ASSERT_FALSE(found.edges_of_ribbon.empty());
  Matrix3Xd moved = planted.positions;
  apply_scheme_a(grid, bodies.ribbon.surface(), *bodies.obstacle, found.edges_of_ribbon, 0.01,
                 moved);
  // By hand: 0.3 below the floor, moved up to 0.01 above it; nobody else moves.
  EXPECT_NEAR(moved(1, astray), -0.49, 1e-12);
  Matrix3Xd others = moved - planted.positions;
  others.col(astray).setZero();
  EXPECT_EQ(others.norm(), 0);
}

TEST(SchemeA, frees_a_border_particle_with_fewer_edges_too) {
  const RibbonGrid grid{7, 5};
  OverFloor planted = ribbon_over_floor(grid, -0.5);
  planted.positions(1, 0) = -1;
  Bodies& bodies = planted.bodies;
  const auto detect = [&] {
    return mutual_penetrations(bodies.ribbon.surface(),
                               bodies.ribbon.triangle_bvh(planted.positions), *bodies.obstacle,
                               planted.positions)
        .edges_of_ribbon;
  };
  const auto found = detect();
  ASSERT_FALSE(found.empty());
  apply_scheme_a(grid, bodies.ribbon.surface(), *bodies.obstacle, found, 0.01, planted.positions);
  EXPECT_TRUE(detect().empty());
}

TEST(SchemeA, brings_a_particle_back_through_a_thin_plate_and_leaves_its_neighbours) {
  const RibbonGrid grid{7, 5};
  const int astray = grid.particle(3, 2);
  // A plate 0.1 thick: the upper side faces up, the lower side down; its rim is far away.
  Matrix3Xd plate_corners(3, 8);
  plate_corners.leftCols(4) << -50, 50, 50, -50, -0.5, -0.5, -0.5, -0.5, 50, 50, -50, -50;
  plate_corners.rightCols(4) = plate_corners.leftCols(4);
  plate_corners.rightCols(4).row(1).setConstant(-0.6);
  Matrix3Xd positions = flat_ribbon(grid);
  positions(1, astray) = -0.8;
  Eigen::Matrix3Xi plate(3, 4);
  plate << 0, 0, 5, 6, 1, 2, 4, 4, 2, 3, 6, 7;
  Bodies bodies{grid, ObstacleBody(plate, plate_corners)};
  const auto found = mutual_penetrations(
      bodies.ribbon.surface(), bodies.ribbon.triangle_bvh(positions), *bodies.obstacle, positions);
  Matrix3Xd moved = positions;
  apply_scheme_a(grid, bodies.ribbon.surface(), *bodies.obstacle, found.edges_of_ribbon, 0.01,
                 moved);
  EXPECT_NEAR(moved(1, astray), -0.49, 1e-12);
  moved.col(astray) = positions.col(astray);
  EXPECT_EQ(moved, positions);
}

// The folded ribbon with its returning half tilted so that one selvage dips through the lower half.
Matrix3Xd selvage_dips_in(const RibbonGrid& grid) {
  Matrix3Xd positions = folded_ribbon(grid, 2);
  for (int row = 14; row <= 16; ++row) positions(1, grid.particle(row, 0)) = -0.3;
  return positions;
}

TEST(SchemeB, curls_the_selvage_in_across_the_ribbon) {
  const RibbonGrid grid{21, 5};
  Matrix3Xd positions = selvage_dips_in(grid);
  Bodies bodies = ribbon_alone(grid);
  const auto found = self_penetrations(bodies.ribbon.surface(),
                                       bodies.ribbon.triangle_bvh(positions), boxes, positions);
  ASSERT_FALSE(found.empty());
  const Matrix3Xd before = positions;
  apply_scheme_b(grid, bodies.ribbon.surface(), found, 0.5, positions);
  const Matrix3Xd moved = positions - before;
  // Row 15's line runs from (y = -0.3) up to the flat rest at y = 2: the mean of its edges is up
  // and across, by hand (0, 2.3, 4) over its length.
  const Vector3d direction = Vector3d(0, 2.3, 4).normalized();
  const int dipped = grid.particle(15, 0);
  EXPECT_GT(moved.col(dipped).norm(), 0.1);
  EXPECT_NEAR(moved.col(dipped).normalized().dot(direction), 1, 1e-9);
  // Neighbours across move along with it, less; the other selvage stays.
  EXPECT_GT(moved.col(grid.particle(15, 1)).norm(), 0);
  EXPECT_LT(moved.col(grid.particle(15, 1)).norm(), moved.col(dipped).norm());
  EXPECT_EQ(moved.col(grid.particle(15, 4)).norm(), 0);
  EXPECT_EQ(moved.col(grid.particle(3, 0)).norm(), 0);
}

TEST(SchemeB, follows_the_width_only_up_to_the_folding_particle) {
  const RibbonGrid grid{21, 5};
  Matrix3Xd positions = selvage_dips_in(grid);
  // Rows 14 to 16 turn back after the second particle: edge 2 points against edge 0.
  for (int row = 14; row <= 16; ++row)
    for (int column = 2; column < 5; ++column)
      positions.col(grid.particle(row, column)) += Vector3d(0, -5, -3.5);
  Bodies bodies = ribbon_alone(grid);
  const Vector3d e0 = positions.col(grid.particle(15, 1)) - positions.col(grid.particle(15, 0));
  const Vector3d e1 = positions.col(grid.particle(15, 2)) - positions.col(grid.particle(15, 1));
  ASSERT_LT(e0.dot(e1), 0);
  std::vector<Penetration> planted(1);
  const std::array<int, 2> edge = {grid.particle(15, 0), grid.particle(16, 0)};
  const auto& edges = bodies.ribbon.surface().edges;
  planted[0].edge = static_cast<int>(std::find(edges.begin(), edges.end(), edge) - edges.begin());
  const Matrix3Xd before = positions;
  apply_scheme_b(grid, bodies.ribbon.surface(), planted, 0.5, positions);
  EXPECT_NEAR((positions - before).col(edge[0]).normalized().dot(e0.normalized()), 1, 1e-9);
}

TEST(SchemeB, leaves_edges_inside_the_ribbon_to_scheme_c) {
  const RibbonGrid grid{21, 5};
  EXPECT_TRUE(is_border_edge(grid, {grid.particle(3, 0), grid.particle(4, 0)}));
  EXPECT_TRUE(is_border_edge(grid, {grid.particle(3, 4), grid.particle(4, 4)}));
  EXPECT_TRUE(is_border_edge(grid, {grid.particle(0, 1), grid.particle(0, 2)}));
  EXPECT_FALSE(is_border_edge(grid, {grid.particle(3, 1), grid.particle(4, 1)}));
  EXPECT_FALSE(is_border_edge(grid, {grid.particle(3, 0), grid.particle(3, 1)}));
}

TEST(SchemeC, moves_the_particle_that_went_through_back_to_the_majority) {
  const RibbonGrid grid{21, 5};
  Matrix3Xd positions = folded_ribbon(grid, 0.5);
  const int astray = grid.particle(15, 2);
  positions(1, astray) = -0.02;
  Bodies bodies = ribbon_alone(grid);
  const auto found = self_penetrations(bodies.ribbon.surface(),
                                       bodies.ribbon.triangle_bvh(positions), boxes, positions);
  ASSERT_FALSE(found.empty());
  apply_scheme_c(grid, bodies.ribbon.surface(), found, 0.01, positions);
  EXPECT_TRUE(self_penetrations(bodies.ribbon.surface(), bodies.ribbon.triangle_bvh(positions),
                                boxes, positions)
                  .empty());
  EXPECT_GT(positions(1, astray), 0);
}

}  // namespace ribbon::recovery_schemes_test
