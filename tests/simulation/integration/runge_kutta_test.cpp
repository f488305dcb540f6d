#include "simulation/integration/integrator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/integration/spring_networks.h"

namespace ribbon::runge_kutta_test {

using Eigen::Matrix3Xd;

// Two particles of mass 2 on a spring of 9 N/m, released at elongation 0.1 along x: they swing with
// angular frequency sqrt(2 * 9 / 2) = 3.
Cloth stretched_pair() {
  Cloth cloth;
  cloth.positions = Matrix3Xd::Zero(3, 2);
  cloth.positions(0, 1) = 1.1;
  cloth.velocities = Matrix3Xd::Zero(3, 2);
  cloth.particle_mass_kg = 2;
  return cloth;
}

// The pair after `steps` steps of step_s.
Matrix3Xd swung_pair(double step_s, int steps) {
  Cloth cloth = stretched_pair();
  const auto integrator = runge_kutta(one_spring(9, 1), {step_s, cloth.particle_mass_kg});
  for (int i = 0; i < steps; ++i) integrator->displace(Matrix3Xd(3, 0), cloth);
  return cloth.positions;
}

double error_after_one_second(int steps) {
  const Matrix3Xd positions = swung_pair(1.0 / steps, steps);
  return std::abs(positions(0, 1) - positions(0, 0) - 1 - 0.1 * std::cos(3.0));
}

TEST(RungeKutta, converges_with_fourth_order) {
  const double order = std::log2(error_after_one_second(80) / error_after_one_second(160));
  EXPECT_NEAR(order, 4, 0.2);
  EXPECT_LT(error_after_one_second(40), 1e-6);
}

TEST(RungeKutta, divides_a_long_step_into_smaller_ones) {
  // Gershgorin takes the pair for one of frequency sqrt(2 * 9 / 2) = 3, so 2.5 / 3 s are stable.
  EXPECT_EQ(swung_pair(3.2, 1), swung_pair(0.8, 4));
}

TEST(RungeKuttaSubsteps, keep_the_stiffest_sample_of_the_paper_bounded) {
  // k/m = 1e6 at dt = 0.01 (section 6.2): a plain step multiplies the fastest swing by 4e4.
  const RibbonGrid grid{12, 8};
  const double mass_kg = 1e-4;
  const SpringNetwork network =
      spring_network({grid, 1.1, 0.7}, {.stretch = 100, .shear = 100, .bend = 100});
  const auto integrator = runge_kutta(network, {0.01, mass_kg});
  EXPECT_GT(integrator->substeps(), 10);
  Cloth cloth;
  cloth.particle_mass_kg = mass_kg;
  cloth.positions.resize(3, grid.particle_count());
  cloth.velocities = Matrix3Xd::Zero(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p)
    cloth.positions.col(p) << 0.1 * grid.row(p) + 1e-3 * ((p * 37) % 11), 0.1 * grid.column(p),
        1e-3 * ((p * 53) % 7);
  double largest_m_s = 0;
  for (int i = 0; i < 50; ++i) {
    integrator->displace(Matrix3Xd(3, 0), cloth);
    largest_m_s = std::max(largest_m_s, cloth.velocities.cwiseAbs().maxCoeff());
  }
  EXPECT_LT(largest_m_s, 20);  // about elongation 1e-2 m times frequency 3e3 / s at most
}

TEST(RungeKuttaSubsteps, of_the_stiffest_scene_on_the_lightest_ribbon_are_a_number) {
  const RibbonGrid grid{4, 4};
  const SpringNetwork network = spring_network({grid, 1, 1}, {.stretch = 1e12, .shear = 1e12});
  EXPECT_GT(runge_kutta(network, {1e3, 1e-13, 1e12})->substeps(), 1'000'000);
}

}  // namespace ribbon::runge_kutta_test
