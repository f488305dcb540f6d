#include "simulation/fastening/fastening_force.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/state/smoothed_directions.h"

namespace ribbon::fastening_force_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// A straight ribbon along x at distance 2 from the y axis, its rows 1 m apart.
Matrix3Xd straight(const RibbonGrid& grid) {
  Matrix3Xd positions(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p)
    positions.col(p) << grid.row(p) - (grid.along - 1) / 2.0, grid.column(p), 2;
  return positions;
}

TEST(SmoothedDirections, of_a_straight_ribbon_are_its_direction) {
  const RibbonGrid grid{9, 2};
  const Matrix3Xd directions = smoothed_directions_along(grid, straight(grid));
  for (int p = 0; p < grid.particle_count(); ++p)
    EXPECT_TRUE(directions.col(p).isApprox(Vector3d::UnitX())) << p;
}

TEST(SmoothedDirections, fade_where_the_ribbon_is_folded) {
  // By hand: x is 0, 1, 0, 1, ... along each column, so that edges cancel in pairs.
  const RibbonGrid grid{8, 2};
  Matrix3Xd positions = straight(grid);
  for (int p = 0; p < grid.particle_count(); ++p) positions(0, p) = grid.row(p) % 2;
  const Matrix3Xd directions = smoothed_directions_along(grid, positions);
  // Row 4: rows 1 to 6, five edges of length 1 that add up to -1.
  EXPECT_TRUE(directions.col(grid.particle(4, 0)).isApprox(Vector3d(-0.2, 0, 0)));
}

TEST(FasteningForce, pulls_each_half_toward_its_own_end) {
  const RibbonGrid grid{9, 2};
  const FasteningForce force({.speed_m_s = 1}, 1, grid, straight(grid), 0.5);
  const Matrix3Xd forces = force.at(straight(grid));
  for (int p = 0; p < grid.particle_count(); ++p) {
    const double way = grid.row(p) - 4;
    EXPECT_GE(forces(0, p) * way, 0);
    EXPECT_EQ(forces(0, p) == 0, way == 0);
  }
}

TEST(FasteningForce, is_proportional_to_the_distance_from_the_axis) {
  const RibbonGrid grid{9, 2};
  const Matrix3Xd positions = straight(grid);
  const FasteningForce force({.speed_m_s = 1}, 1, grid, positions, 0.5);
  const Matrix3Xd forces = force.at(positions);
  // Rows 5 and 8 lie 1 and 4 m along x and 2 m beside the axis.
  EXPECT_NEAR(forces.col(grid.particle(8, 0)).norm() / forces.col(grid.particle(5, 0)).norm(),
              std::sqrt(20.0) / std::sqrt(5.0), 1e-12);
}

TEST(FasteningForce, balances_air_resistance_at_the_given_speed_and_mean_distance) {
  const RibbonGrid grid{9, 2};
  const double mass_kg = 0.5;
  const double air_per_s = 3;
  const double speed_m_s = 0.7;
  const FasteningForce force({.speed_m_s = speed_m_s}, air_per_s, grid, straight(grid), mass_kg);
  const Matrix3Xd forces = force.at(straight(grid));
  double mean_force = 0;
  for (int p = 0; p < grid.particle_count(); ++p) {
    if (grid.row(p) != 4) {
      mean_force += forces.col(p).norm();
      continue;
    }
    // The middle row is pulled both ways and stays; at 2 m its share follows from row 5's.
    mean_force += 2 / std::sqrt(5.0) * forces.col(grid.particle(5, 0)).norm();
  }
  EXPECT_NEAR(mean_force / grid.particle_count(), mass_kg * air_per_s * speed_m_s, 1e-9);
}

TEST(FasteningForce, by_the_ends_pulls_a_square_of_cloth_at_each_end) {
  const RibbonGrid grid{9, 2};
  const FasteningForce force({.speed_m_s = 1, .pull = FasteningPull::ends}, 1, grid, straight(grid),
                             0.5);
  const Matrix3Xd forces = force.at(straight(grid));
  for (int p = 0; p < grid.particle_count(); ++p) {
    const double way = grid.row(p) - 4;
    EXPECT_EQ(forces.col(p).norm() > 0, std::abs(way) > 2) << p;
    EXPECT_GE(forces(0, p) * way, 0);
  }
}

// By hand: half of 18 particles of 0.5 kg at 0.7 m/s against 3 per second take 9.45 N.
TEST(FasteningForce, by_the_ends_draws_each_half_at_the_given_speed) {
  const RibbonGrid grid{9, 2};
  const FasteningForce force({.speed_m_s = 0.7, .pull = FasteningPull::ends}, 3, grid,
                             straight(grid), 0.5);
  const Matrix3Xd forces = force.at(straight(grid));
  EXPECT_NEAR(forces.leftCols(9).rowwise().sum().norm(), 9.45, 1e-12);
  EXPECT_NEAR(forces.rightCols(9).rowwise().sum().norm(), 9.45, 1e-12);
  // The speed that the scene wants of the particles that are held.
  EXPECT_NEAR(forces.col(0).norm() / force.newton_per_m_s(), 0.7, 1e-12);
}

TEST(FasteningForce, by_the_ends_holds_no_more_than_there_is) {
  const RibbonGrid grid{4, 6};
  const FasteningForce force({.speed_m_s = 1, .pull = FasteningPull::ends}, 1, grid, straight(grid),
                             1);
  // By hand: 12 particles a half, all of them held.
  EXPECT_NEAR(force.at(straight(grid)).leftCols(12).rowwise().sum().norm(), 12, 1e-12);
}

}  // namespace ribbon::fastening_force_test
