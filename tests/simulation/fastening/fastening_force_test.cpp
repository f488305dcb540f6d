#include "simulation/fastening/fastening_force.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/state/smoothed_tangents.h"

namespace ribbon::fastening_force_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

const RibbonGrid grid{9, 2};
constexpr double mass_kg = 0.5;

// A ribbon along x at distance 2 from the y axis, its rows 1 m apart.
Matrix3Xd straight(const RibbonGrid& particles) {
  Matrix3Xd positions(3, particles.particle_count());
  for (int p = 0; p < particles.particle_count(); ++p)
    positions.col(p) << particles.row(p) - (particles.along - 1) / 2.0, particles.column(p), 2;
  return positions;
}

FasteningForce force_on_straight(const FasteningScene& scene, double air_per_s = 1) {
  return {scene, air_per_s, {grid, 8, 1}, straight(grid), mass_kg};
}

Matrix3Xd forces_on_straight(const FasteningScene& scene, double air_per_s = 1) {
  return force_on_straight(scene, air_per_s).at(straight(grid));
}

TEST(SmoothedTangents, of_a_straight_ribbon_are_its_direction) {
  const Matrix3Xd directions = SmoothedTangents(grid).at(straight(grid));
  for (int p = 0; p < grid.particle_count(); ++p)
    EXPECT_TRUE(directions.col(p).isApprox(Vector3d::UnitX())) << p;
}

TEST(SmoothedTangents, fade_where_the_ribbon_is_folded) {
  // By hand: x is 0, 1, 0, 1, ... along each column, so that edges cancel in pairs.
  const RibbonGrid folded{8, 2};
  Matrix3Xd positions = straight(folded);
  for (int p = 0; p < folded.particle_count(); ++p) positions(0, p) = folded.row(p) % 2;
  const Matrix3Xd directions = SmoothedTangents(folded).at(positions);
  // Row 4: rows 1 to 6, five edges of length 1 that add up to -1.
  EXPECT_TRUE(directions.col(folded.particle(4, 0)).isApprox(Vector3d(-0.2, 0, 0)));
}

TEST(FasteningForce, pulls_each_half_toward_its_own_end) {
  const Matrix3Xd forces = forces_on_straight({.speed_m_s = 1});
  for (int p = 0; p < grid.particle_count(); ++p) {
    const double from_middle = grid.row(p) - 4;
    EXPECT_GE(forces(0, p) * from_middle, 0);
    EXPECT_EQ(forces(0, p) == 0, from_middle == 0);
  }
}

TEST(FasteningForce, is_proportional_to_the_distance_from_the_axis) {
  const Matrix3Xd forces = forces_on_straight({.speed_m_s = 1});
  // Rows 5 and 8 lie 1 and 4 m along x and 2 m beside the axis.
  EXPECT_NEAR(forces.col(grid.particle(8, 0)).norm() / forces.col(grid.particle(5, 0)).norm(),
              std::sqrt(20.0) / std::sqrt(5.0), 1e-12);
}

TEST(FasteningForce, balances_air_resistance_at_the_given_speed_and_mean_distance) {
  const Matrix3Xd forces = forces_on_straight({.speed_m_s = 0.7}, 3);
  double mean_force = forces.colwise().norm().sum();
  // The middle row is pulled both ways and stays; at 2 m its strength follows from row 5's.
  mean_force += 2 * 2 / std::sqrt(5.0) * forces.col(grid.particle(5, 0)).norm();
  EXPECT_NEAR(mean_force / grid.particle_count(), mass_kg * 3 * 0.7, 1e-9);
}

TEST(FasteningForce, by_the_ends_pulls_a_square_of_cloth_at_each_end) {
  const Matrix3Xd forces = forces_on_straight({.speed_m_s = 1, .pull = FasteningPull::ends});
  for (int p = 0; p < grid.particle_count(); ++p) {
    const double from_middle = grid.row(p) - 4;
    EXPECT_EQ(forces.col(p).norm() > 0, std::abs(from_middle) > 2) << p;
    EXPECT_GE(forces(0, p) * from_middle, 0);
  }
}

// By hand: half of 18 particles of 0.5 kg at 0.7 m/s against 3 per second take 9.45 N.
TEST(FasteningForce, by_the_ends_draws_each_half_at_the_given_speed) {
  FasteningForce force = force_on_straight({.speed_m_s = 0.7, .pull = FasteningPull::ends}, 3);
  const Matrix3Xd forces = force.at(straight(grid));
  EXPECT_NEAR(forces.leftCols(9).rowwise().sum().norm(), 9.45, 1e-12);
  EXPECT_NEAR(forces.rightCols(9).rowwise().sum().norm(), 9.45, 1e-12);
  // The speed that the scene wants of the particles that are held.
  EXPECT_NEAR(forces.col(0).norm() / force.newton_per_m_s(), 0.7, 1e-12);
}

TEST(FasteningForce, by_the_ends_holds_no_more_than_there_is) {
  const RibbonGrid wide{4, 6};
  FasteningForce force({.speed_m_s = 1, .pull = FasteningPull::ends}, 1, {wide, 3, 5},
                       straight(wide), 1);
  // By hand: 12 particles a half, all of them held.
  EXPECT_NEAR(force.at(straight(wide)).leftCols(12).rowwise().sum().norm(), 12, 1e-12);
}

// Forces are those on particles of mean mass; the last row weighs five times as much as the first.
TEST(FasteningForce, draws_both_halves_as_hard_where_rows_weigh_differently) {
  RestSize tapered{grid, 8, 0.6};
  for (int row = 0; row < grid.along; ++row) tapered.row_widths_m.push_back(0.2 + 0.1 * row);
  for (const FasteningPull pull : {FasteningPull::distributed, FasteningPull::ends}) {
    FasteningForce force({.speed_m_s = 0.7, .pull = pull}, 3, tapered, straight(grid), mass_kg);
    Eigen::Vector2d pulled = Eigen::Vector2d::Zero();
    const Matrix3Xd forces = force.at(straight(grid));
    for (int p = 0; p < grid.particle_count(); ++p)
      pulled[grid.row(p) < grid.along / 2 ? 0 : 1] +=
          forces(0, p) * tapered.row_width_m(grid.row(p)) / tapered.width_m;
    EXPECT_LT(pulled[0], -1);
    // Published, it also goes by the distance from the axis, whose mean over the masses differs.
    EXPECT_NEAR(pulled.sum(), 0, pull == FasteningPull::ends ? 1e-12 : 0.15 * pulled[1]);
  }
}

}  // namespace ribbon::fastening_force_test
