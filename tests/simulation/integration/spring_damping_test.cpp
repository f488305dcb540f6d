#include "simulation/integration/spring_damping.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "parallel/instruction_set.h"
#include "simulation/state/cloth.h"

namespace ribbon::spring_damping_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr RibbonGrid grid{12, 5};

SpringNetwork network_of(double stiffness, double damping) {
  return spring_network(
      {grid, 1.1, 0.4},
      {.stretch = stiffness, .shear = stiffness, .bend = stiffness, .damping = damping});
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
  SpringDamping(network, cloth.particle_mass_kg).apply(h, positions, velocities);
  cloth.velocities = velocities.transpose();
}

Vector3d angular_momentum(const Cloth& cloth) {
  Vector3d sum = Vector3d::Zero();
  for (Eigen::Index p = 0; p < cloth.particle_count(); ++p)
    sum += Vector3d(cloth.positions.col(p)).cross(Vector3d(cloth.velocities.col(p)));
  return sum;
}

TEST(SpringDamping, keeps_momentum_and_angular_momentum_and_lets_energy_never_grow) {
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

// By hand: k = 8 N/m between two particles of 1 kg swing at 4 rad/s; with 0.25 of the critical
// damping their parting decays by 2 * 0.25 * 4 = 2 per second.
TEST(SpringDamping, is_the_fraction_of_the_critical_one_that_was_asked_for) {
  const SpringNetwork pair = spring_network({{2, 1}, 1, 1}, {.stretch = 8, .damping = 0.25});
  Cloth cloth{Matrix3Xd::Zero(3, 2), Matrix3Xd::Zero(3, 2), 1};
  cloth.positions(0, 1) = 1;
  cloth.velocities << -1, 1, 1, 1, 0, 0;
  for (int i = 0; i < 1000; ++i) damp(pair, 1e-3, cloth);
  EXPECT_NEAR(cloth.velocities(0, 1), std::exp(-2), 1e-3);
  EXPECT_EQ(cloth.velocities(1, 1), 1);
}

TEST(SpringDamping, leaves_a_ribbon_that_turns_as_one_body_alone) {
  Cloth cloth = crumpled();
  for (Eigen::Index p = 0; p < cloth.particle_count(); ++p)
    cloth.velocities.col(p) = Vector3d(1, 2, 3) + Vector3d(3, -1, 2).cross(cloth.positions.col(p));
  const Matrix3Xd before = cloth.velocities;
  damp(network_of(10, 0.5), 0.01, cloth);
  EXPECT_TRUE(cloth.velocities.isApprox(before, 1e-12));
}

TEST(SpringDamping, does_not_divide_by_a_length_of_zero) {
  Cloth cloth{Matrix3Xd::Zero(3, grid.particle_count()), Matrix3Xd::Ones(3, grid.particle_count()),
              1};
  damp(network_of(10, 0.5), 0.01, cloth);
  EXPECT_TRUE(cloth.velocities.isOnes());
}

TEST(SpringDamping, gives_the_same_bits_with_any_instructions) {
  const auto damped = [](InstructionSet set) {
    choose_instruction_set(set);
    Cloth cloth = crumpled();
    damp(network_of(10, 0.5), 0.01, cloth);
    choose_instruction_set(best_instruction_set());
    return cloth.velocities;
  };
  EXPECT_EQ(damped(InstructionSet::baseline), damped(best_instruction_set()));
}

}  // namespace ribbon::spring_damping_test
