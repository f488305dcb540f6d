#include "simulation/truncation/row_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/vectors.h"
#include "simulation/state/edge_strain.h"

namespace ribbon::row_chain_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double limit = 0.08;

RestSize band(int rows) {
  return {{rows, 3}, 0.01 * (rows - 1), 0.02};
}

// In the plane z = 0, stretched to its limit everywhere, bent to a circle of that radius.
Cloth taut(const RestSize& size, double radius_m) {
  Cloth cloth{Matrix3Xd(3, size.grid.particle_count()),
              Matrix3Xd::Zero(3, size.grid.particle_count()), 0.001, lightness(size)};
  const double turn = 2 * std::asin((1 + limit) * size.along_m() / (2 * radius_m));
  for (int particle = 0; particle < size.grid.particle_count(); ++particle) {
    const double angle = turn * size.grid.row(particle);
    cloth.positions.col(particle) << radius_m * std::sin(angle), radius_m * (1 - std::cos(angle)),
        size.place_m(particle).y();
  }
  return cloth;
}

double longest_strain(const RestSize& size, const Cloth& cloth) {
  const SpringFamily along = stretch_families(size)[0];
  double longest = -1;
  for_each_spring(size.grid, along, [&](int a, int b) {
    longest = std::max(longest, edge_strain(along, a, b, cloth.positions));
  });
  return longest;
}

Vector3d sum_by_mass(const Matrix3Xd& of_particles, const Cloth& cloth) {
  Vector3d sum = Vector3d::Zero();
  for (int particle = 0; particle < of_particles.cols(); ++particle)
    sum += of_particles.col(particle) / cloth.inverse_mass(particle);
  return sum;
}

double kinetic_energy_j(const Cloth& cloth) {
  double energy_j = 0;
  for (int particle = 0; particle < cloth.particle_count(); ++particle)
    energy_j +=
        0.5 * squared_length_of(cloth.velocities.col(particle)) / cloth.inverse_mass(particle);
  return energy_j;
}

void set_row(const RestSize& size, int row, const Vector3d& by, Matrix3Xd& of_particles) {
  for (int column = 0; column < size.grid.across; ++column)
    of_particles.col(size.grid.particle(row, column)) += by;
}

// What takes sweeps, which reach one row a time, thousands.
TEST(RowChain, lets_go_at_once_what_one_end_is_pulled) {
  const RestSize size = band(300);
  Cloth cloth = taut(size, 1e6);
  set_row(size, 299, {0.002, 0, 0}, cloth.positions);
  const Vector3d before = sum_by_mass(cloth.positions, cloth);
  RowChain(size, limit).shorten(cloth);
  EXPECT_LE(longest_strain(size, cloth), limit + 1e-9);
  EXPECT_LT((sum_by_mass(cloth.positions, cloth) - before).norm(), 1e-12);
}

TEST(RowChain, holds_round_a_bend) {
  const RestSize size = band(100);
  Cloth cloth = taut(size, 0.2);
  set_row(size, 99, {0.001, -0.001, 0}, cloth.positions);
  const Vector3d before = sum_by_mass(cloth.positions, cloth);
  const double strained = longest_strain(size, cloth);
  RowChain(size, limit).shorten(cloth);
  EXPECT_LT(longest_strain(size, cloth), limit + 0.02 * (strained - limit));
  EXPECT_LT((sum_by_mass(cloth.positions, cloth) - before).norm(), 1e-13);
}

TEST(RowChain, leaves_alone_what_is_within_the_limit) {
  const RestSize size = band(50);
  Cloth cloth = taut(size, 0.3);
  cloth.positions *= 0.999;
  cloth.velocities.setRandom();
  const Cloth before = cloth;
  RowChain(size, limit).shorten(cloth);
  EXPECT_EQ(cloth.positions, before.positions);
  EXPECT_EQ(cloth.velocities, before.velocities);
}

// By hand: what is taut moves as one with what pulls it, at the mean of their velocities.
TEST(RowChain, takes_the_speed_at_which_links_under_tension_grow) {
  const RestSize size = band(4);
  Cloth cloth = taut(size, 1e6);
  set_row(size, 3, {0.001, 0, 0}, cloth.positions);
  set_row(size, 3, {4, 1, 0}, cloth.velocities);
  RowChain(size, limit).shorten(cloth);
  for (int particle = 0; particle < size.grid.particle_count(); ++particle) {
    EXPECT_NEAR(cloth.velocities(0, particle), 1, 1e-6) << particle;
    EXPECT_NEAR(cloth.velocities(1, particle), particle < 9 ? 0 : 1, 1e-6) << particle;
  }
}

TEST(RowChain, leaves_the_speed_at_which_links_shrink) {
  const RestSize size = band(4);
  Cloth cloth = taut(size, 1e6);
  set_row(size, 3, {0.001, 0, 0}, cloth.positions);
  set_row(size, 3, {-4, 0, 0}, cloth.velocities);
  const Matrix3Xd before = cloth.velocities;
  RowChain(size, limit).shorten(cloth);
  EXPECT_EQ(cloth.velocities, before);
}

// A band whose rows weigh from a half to one and a half of the mean, however it moves.
TEST(RowChain, keeps_momentum_and_adds_no_energy) {
  RestSize size = band(60);
  for (int row = 0; row < 60; ++row) size.row_widths_m.push_back(0.02 * (0.5 + row / 59.0));
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 1);
  RowChain chain(size, limit);
  for (int trial = 0; trial < 100; ++trial) {
    Cloth cloth = taut(size, 0.1);
    for (double& coordinate : cloth.positions.reshaped()) coordinate += 5e-4 * noise(random);
    for (double& coordinate : cloth.velocities.reshaped()) coordinate = noise(random);
    const Cloth before = cloth;
    chain.shorten(cloth);
    EXPECT_NE(cloth.velocities, before.velocities);
    EXPECT_LE(kinetic_energy_j(cloth), kinetic_energy_j(before));
    EXPECT_LT((sum_by_mass(cloth.velocities, cloth) - sum_by_mass(before.velocities, cloth)).norm(),
              1e-13);
    EXPECT_LT((sum_by_mass(cloth.positions, cloth) - sum_by_mass(before.positions, cloth)).norm(),
              1e-14);
  }
}

// A particle of row 5 touches one of the obstacle's.
TEST(RowChain, ends_at_rows_that_touch_something) {
  const RestSize size = band(12);
  Cloth cloth = taut(size, 1e6);
  set_row(size, 11, {0.003, 0, 0}, cloth.positions);
  set_row(size, 0, {-0.003, 0, 0}, cloth.positions);
  set_row(size, 5, {0, 0.002, 0}, cloth.positions);
  const Matrix3Xd before = cloth.positions;
  RowChain chain(size, limit);
  ContactConstraint contact;
  contact.vertices = {size.grid.particle(5, 1), 36, 37, 38};
  chain.break_at({&contact, 1});
  chain.shorten(cloth);
  for (int column = 0; column < 3; ++column) {
    const int touching = size.grid.particle(5, column);
    EXPECT_EQ(cloth.positions.col(touching), before.col(touching));
    EXPECT_GT(cloth.positions(0, size.grid.particle(0, column)), before(0, column));
    EXPECT_LT(cloth.positions(0, size.grid.particle(11, column)),
              before(0, size.grid.particle(11, column)));
  }
  // No longer, once nothing touches.
  chain.break_at({});
  chain.shorten(cloth);
  EXPECT_NE(cloth.positions.col(size.grid.particle(5, 1)), before.col(size.grid.particle(5, 1)));
}

}  // namespace ribbon::row_chain_test
