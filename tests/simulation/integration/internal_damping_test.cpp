#include "simulation/integration/internal_damping.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "parallel/any_instructions.h"
#include "parallel/any_threads.h"
#include "simulation/state/cloth.h"

namespace ribbon::internal_damping_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr RibbonGrid grid{75, 9};  // three lots of rows, more than four columns

// Rows of 0.2 to 0.6 m.
RestSize tapered() {
  RestSize size{grid, 1.1, 0.4};
  for (int row = 0; row < grid.along; ++row)
    size.row_widths_m.push_back(0.2 + 0.4 * row / (grid.along - 1));
  return size;
}

SpringNetwork network_of(double stiffness, double damping,
                         const RestSize& size = {grid, 1.1, 0.4}) {
  return spring_network(
      size, {.stretch = stiffness, .shear = stiffness, .bend = stiffness, .damping = damping});
}

Cloth crumpled() {
  Cloth cloth{Matrix3Xd(3, grid.particle_count()), Matrix3Xd(3, grid.particle_count()), 0.3};
  std::mt19937 random(3);
  for (auto* values : {&cloth.positions, &cloth.velocities})
    for (double& value : values->reshaped())
      value = 1e-9 * static_cast<double>(random() % 1'000'000'000);
  return cloth;
}

void damp(const SpringNetwork& network, double h, Cloth& cloth) {
  const Eigen::MatrixX3d positions = cloth.positions.transpose();
  Eigen::MatrixX3d velocities = cloth.velocities.transpose();
  InternalDamping(network, cloth.particle_mass_kg, cloth.lightness).apply(h, positions, velocities);
  cloth.velocities = velocities.transpose();
}

Vector3d angular_momentum(const Cloth& cloth) {
  Vector3d sum = Vector3d::Zero();
  for (Eigen::Index p = 0; p < cloth.particle_count(); ++p)
    sum += Vector3d(cloth.positions.col(p)).cross(Vector3d(cloth.velocities.col(p)));
  return sum;
}

TEST(InternalDamping, keeps_momentum_and_angular_momentum_and_lets_energy_never_grow) {
  for (const double stiffness : {1e-3, 1.0, 1e9}) {
    Cloth cloth = crumpled();
    const Cloth before = cloth;
    double energy = cloth.velocities.squaredNorm();
    for (int i = 0; i < 20; ++i) {
      damp(network_of(stiffness, 0.5), 0.01, cloth);
      EXPECT_LE(cloth.velocities.squaredNorm(), energy);
      energy = cloth.velocities.squaredNorm();
    }
    EXPECT_LT(energy, before.velocities.squaredNorm());
    EXPECT_EQ(cloth.positions, before.positions);
    EXPECT_NEAR((cloth.velocities - before.velocities).rowwise().sum().norm(), 0, 1e-12);
    EXPECT_NEAR((angular_momentum(cloth) - angular_momentum(before)).norm(), 0, 1e-12);
  }
}

TEST(InternalDamping, of_rows_that_weigh_differently_keeps_momentum_and_lets_energy_never_grow) {
  for (const double stiffness : {1e-3, 1.0, 1e9}) {
    Cloth cloth = crumpled();
    cloth.lightness = lightness(tapered());
    const Eigen::ArrayXd heaviness = cloth.lightness.inverse();
    const auto momentum = [&] { return (cloth.velocities * heaviness.matrix()).eval(); };
    const auto energy = [&] {
      return (cloth.velocities.colwise().squaredNorm() * heaviness.matrix()).value();
    };
    const Vector3d momentum_before = momentum();
    double energy_before = energy();
    for (int i = 0; i < 20; ++i) {
      damp(network_of(stiffness, 0.5, tapered()), 0.01, cloth);
      EXPECT_LE(energy(), energy_before * (1 + 1e-12));
      energy_before = energy();
    }
    EXPECT_NEAR((momentum() - momentum_before).norm(), 0, 1e-11);
  }
}

// By hand: as below, but the second particle weighs 3 kg in a mean of 2 kg: they swing at
// sqrt(8 (1 / 1 + 1 / 3)) rad/s against each other.
TEST(InternalDamping, of_particles_that_weigh_differently_is_the_fraction_that_was_asked_for) {
  const SpringNetwork pair = spring_network({{2, 1}, 1, 1}, {.stretch = 8, .damping = 0.25});
  Cloth cloth{Matrix3Xd::Zero(3, 2), Matrix3Xd::Zero(3, 2), 2, Eigen::Array2d(2, 2 / 3.0)};
  cloth.positions(0, 1) = 1;
  cloth.velocities.row(0) << -3, 1;
  for (int i = 0; i < 1000; ++i) damp(pair, 1e-3, cloth);
  EXPECT_NEAR(cloth.velocities(0, 1), std::exp(-0.5 * std::sqrt(8 * (1 + 1 / 3.0))), 1e-3);
  EXPECT_NEAR(cloth.velocities(0, 0), -3 * cloth.velocities(0, 1), 1e-12);
}

// By hand: k = 8 N/m between two particles of 1 kg swing at 4 rad/s; with 0.25 of the critical
// damping their parting decays by 2 * 0.25 * 4 = 2 per second.
TEST(InternalDamping, is_the_fraction_of_the_critical_one_that_was_asked_for) {
  const SpringNetwork pair = spring_network({{2, 1}, 1, 1}, {.stretch = 8, .damping = 0.25});
  Cloth cloth{Matrix3Xd::Zero(3, 2), Matrix3Xd::Zero(3, 2), 1};
  cloth.positions(0, 1) = 1;
  cloth.velocities << -1, 1, 1, 1, 0, 0;
  for (int i = 0; i < 1000; ++i) damp(pair, 1e-3, cloth);
  EXPECT_NEAR(cloth.velocities(0, 1), std::exp(-2), 1e-3);
  EXPECT_EQ(cloth.velocities(1, 1), 1);
}

// By hand: the middle of three particles swings against the middle of its neighbours with half of
// the mass 1 / 1.5 of both, at sqrt(1.5 * 6) = 3 rad/s on 6 N/m; with 0.25 of the critical damping
// the fold decays by 2 * 0.25 * 3 = 1.5 per second, though its spring keeps its length.
TEST(InternalDamping, slows_folds_along_and_across) {
  for (const RibbonGrid& three : {RibbonGrid{3, 2}, RibbonGrid{2, 3}}) {
    const bool is_along = three.along == 3;
    const SpringNetwork network = spring_network({three, 1, 1}, {.bend = 6, .damping = 0.25});
    Cloth cloth{Matrix3Xd(3, 6), Matrix3Xd::Zero(3, 6), 1};
    for (int p = 0; p < 6; ++p) {
      const int i = is_along ? three.row(p) : three.column(p);
      const int j = is_along ? three.column(p) : three.row(p);
      cloth.positions.col(p) = Vector3d(i, i == 1 ? 0.1 : 0, j);
      cloth.velocities(1, p) = i == 1 ? 2 : -1;
    }
    for (int step = 0; step < 1000; ++step) damp(network, 1e-3, cloth);
    const int middle = is_along ? three.particle(1, 0) : three.particle(0, 1);
    EXPECT_NEAR(cloth.velocities(1, middle), 2 * std::exp(-1.5), 2e-3) << is_along;
    EXPECT_NEAR(cloth.velocities(1, 0), -std::exp(-1.5), 1e-3) << is_along;
  }
}

// By hand: both diagonals of a quad part at speed 2 with 1 / mass = 1/2 + 1/2, at 2 rad/s on 4 N/m.
TEST(InternalDamping, slows_the_twist_of_a_quad) {
  const SpringNetwork quad = spring_network({{2, 2}, 1, 1}, {.bend = 4, .damping = 0.25});
  Cloth cloth{Matrix3Xd(3, 4), Matrix3Xd::Zero(3, 4), 1};
  cloth.positions << 0, 0, 1, 1, 0.1, 0, 0, 0.1, 0, 1, 0, 1;
  cloth.velocities.row(1) << 1, -1, -1, 1;
  for (int step = 0; step < 1000; ++step) damp(quad, 1e-3, cloth);
  EXPECT_NEAR(cloth.velocities(1, 0), std::exp(-1), 1e-3);
  EXPECT_NEAR(cloth.velocities(1, 1), -std::exp(-1), 1e-3);
}

// A ribbon that only folds as a whole, over all of its length, is hardly slowed.
TEST(InternalDamping, lets_wide_folds_open) {
  const SpringNetwork network = network_of(10, 1);
  Cloth cloth{Matrix3Xd(3, grid.particle_count()), Matrix3Xd::Zero(3, grid.particle_count()), 1};
  for (int p = 0; p < grid.particle_count(); ++p) {
    const double along = grid.row(p) - 37.0;
    cloth.positions.col(p) = Vector3d(along, 1e-3 * along * along, grid.column(p));
    cloth.velocities(1, p) = 1e-3 * along * along;
  }
  const Matrix3Xd before = cloth.velocities;
  for (int step = 0; step < 100; ++step) damp(network, 1e-3, cloth);
  EXPECT_LT((cloth.velocities - before).norm(), 0.02 * before.norm());
}

TEST(InternalDamping, leaves_a_ribbon_that_turns_as_one_body_alone) {
  Cloth cloth = crumpled();
  for (Eigen::Index p = 0; p < cloth.particle_count(); ++p)
    cloth.velocities.col(p) = Vector3d(1, 2, 3) + Vector3d(3, -1, 2).cross(cloth.positions.col(p));
  const Matrix3Xd before = cloth.velocities;
  damp(network_of(10, 0.5), 0.01, cloth);
  EXPECT_TRUE(cloth.velocities.isApprox(before, 1e-12));
}

TEST(InternalDamping, does_not_divide_by_a_length_of_zero) {
  Cloth cloth{Matrix3Xd::Zero(3, grid.particle_count()), Matrix3Xd::Ones(3, grid.particle_count()),
              1};
  damp(network_of(10, 0.5), 0.01, cloth);
  EXPECT_TRUE(cloth.velocities.isOnes());
}

TEST(InternalDamping, gives_the_same_bits_with_any_threads_and_instructions) {
  const auto damped = [] {
    Cloth cloth = crumpled();
    damp(network_of(10, 0.5), 0.01, cloth);
    return cloth.velocities;
  };
  EXPECT_EQ(same_for_any_threads(damped), same_for_any_instructions(damped));
}

}  // namespace ribbon::internal_damping_test
