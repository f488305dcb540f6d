#include "simulation/fastening/hanging_weight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "simulation/fastening/yielding.h"
#include "simulation/integration/integrator.h"

namespace ribbon::hanging_weight_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr RestSize size{{41, 4}, 2, 0.15};  // edges of 5 cm
// Undamped: what is held by being put back after each substep would drag on what hangs from it.
constexpr SpringScene stiffness{.stretch = 20, .shear = 10, .bend = 10, .damping = 0};
constexpr double particle_mass_kg = 1e-4;
const Vector3d gravity_m_s2(0, -9.81, 0);

HangingWeight weight() {
  return {size, stiffness, particle_mass_kg, gravity_m_s2};
}

// By hand, of a strain s along and t across in newtons: a cut across is drawn by stretch with
// 4 * 20 * 0.05 s, by bend with 4 * 2 * 10 * 0.1 s and by shear with 6 * 10 * 0.05 (s + t) / 2.
// Along the ribbon, where stretch has 3 * 20 * 0.05 t and bend 2 * 4 * 10 * 0.05 t, nothing draws
// in the end: t = -1.5 s / 8.5.
constexpr double resistance_n = 4 + 8 + 1.5 * (1 - 1.5 / 8.5);
constexpr double row_weight_n = 4 * particle_mass_kg * 9.81;

// All rows one above the other.
Matrix3Xd hanging_straight() {
  Matrix3Xd positions(3, size.grid.particle_count());
  for (int p = 0; p < size.grid.particle_count(); ++p)
    positions.col(p) << 0.05 * size.grid.column(p), -0.05 * size.grid.row(p), 0;
  return positions;
}

TEST(HangingWeight, stretches_the_more_the_more_hangs_from_a_row) {
  const auto strains = weight().strains(hanging_straight());
  ASSERT_EQ(strains.size(), 40U);
  // Below the middle what hangs; above it what stands on its end and does not push.
  for (int row = 0; row < 40; ++row)
    EXPECT_NEAR(strains[row], row < 20 ? 0 : (40 - row) * row_weight_n / resistance_n, 1e-12)
        << row;
}

// By hand: diagonals alone lengthen for nothing, as the ribbon draws in.
TEST(HangingWeight, is_borne_by_no_diagonals_alone_at_any_size) {
  for (const RestSize& any : {RestSize{{400, 8}, 2.7, 0.05}, RestSize{{61, 4}, 2, 0.06},
                              RestSize{{60, 5}, 1.3, 0.03}, RestSize{{200, 4}, 3, 0.04}}) {
    HangingWeight of_any(any, {.shear = 20}, particle_mass_kg, gravity_m_s2);
    Matrix3Xd hanging = Matrix3Xd::Zero(3, any.grid.particle_count());
    for (int p = 0; p < any.grid.particle_count(); ++p) hanging(1, p) = -any.grid.row(p);
    EXPECT_EQ(of_any.strains(hanging).back(), std::numeric_limits<double>::infinity());
  }
}

TEST(HangingWeight, is_nothing_in_what_lies_level) {
  Matrix3Xd level = hanging_straight();
  level.row(1).swap(level.row(2));
  const auto strains = weight().strains(level);
  for (const double strain : strains) EXPECT_EQ(strain, 0);
}

TEST(HangingWeight, counts_the_height_alone_of_what_leans) {
  Matrix3Xd leaning = hanging_straight();
  leaning.row(2) = -0.75 * leaning.row(1);
  leaning /= 1.25;
  EXPECT_NEAR(weight().strains(leaning)[20], 20 * row_weight_n * 0.8 / resistance_n, 1e-12);
}

TEST(HangingWeight, without_springs_nothing_would_bear_it) {
  HangingWeight loose(size, {}, particle_mass_kg, gravity_m_s2);
  const auto strains = loose.strains(hanging_straight());
  EXPECT_EQ(strains[0], 0);
  EXPECT_TRUE(std::isinf(strains[30]));
}

// The lower half of a ribbon whose upper half is held: after ten seconds in thick air it hangs
// still.
Matrix3Xd at_rest() {
  Cloth cloth{hanging_straight(), Matrix3Xd::Zero(3, size.grid.particle_count()), particle_mass_kg};
  const auto integrator =
      symplectic_euler(spring_network(size, stiffness), {0.01, particle_mass_kg, 10, gravity_m_s2});
  const Eigen::Index held = size.grid.particle(21, 0);
  integrator->hold_force(Matrix3Xd(3, 0), cloth);
  for (int substep = 0; substep < 1000 * integrator->substeps(); ++substep) {
    integrator->displace_in_substep(cloth);
    cloth.positions.leftCols(held) = hanging_straight().leftCols(held);
    cloth.velocities.leftCols(held).setZero();
  }
  return cloth.positions;
}

TEST(HangingWeight, is_what_a_hanging_ribbon_comes_to_rest_under) {
  const Matrix3Xd positions = at_rest();
  const auto strains = weight().strains(positions);
  for (int row = 22; row < 38; ++row) {
    const int a = size.grid.particle(row, 1);
    const int b = size.grid.particle(row + 1, 1);
    const double strain = (positions.col(b) - positions.col(a)).norm() / 0.05 - 1;
    EXPECT_NEAR(strains[row] / strain, 1, 0.1) << row;
  }
}

// It is stretched by 0.6 %, and by 0.7 % beside what is held and so cannot draw in or bend.
TEST(HangingWeight, is_not_felt_by_hands_that_yield) {
  const Matrix3Xd positions = at_rest();
  EXPECT_LT(Yielding(size, 0.006).force_fraction(positions), 0.3);
  EXPECT_EQ(Yielding(size, 0.006, weight()).force_fraction(positions), 1);
  const Matrix3Xd pulled = 1.004 * positions;  // what hands add they feel
  EXPECT_NEAR(Yielding(size, 0.006, weight()).force_fraction(pulled), 0.5, 0.3);
}

}  // namespace ribbon::hanging_weight_test
