#include "simulation/integration/spring_force.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ribbon::spring_force_test {

using Eigen::Matrix3Xd;

SpringNetwork one_spring(double resistance, double rest_length_m) {
  SpringNetwork network;
  network.stretch = {resistance, {{0, 1, rest_length_m}}};
  return network;
}

Matrix3Xd forces_of(const SpringNetwork& network, const Matrix3Xd& positions) {
  SpringForces springs(network, static_cast<int>(positions.cols()));
  Eigen::MatrixX3d forces;
  springs.forces(positions.transpose(), forces);
  return forces.transpose();
}

// By hand: 3-4-5 triangle, length 5 at rest 2, elongation 3, resistance 10: 30 N along (0.6, 0.8,
// 0).
TEST(SpringForce, is_resistance_times_elongation_along_the_spring) {
  Matrix3Xd positions(3, 2);
  positions << 0, 3, 0, 4, 1, 1;
  const Matrix3Xd forces = forces_of(one_spring(10, 2), positions);
  EXPECT_TRUE(forces.col(0).isApprox(Eigen::Vector3d(18, 24, 0)));
  EXPECT_TRUE(forces.col(1).isApprox(Eigen::Vector3d(-18, -24, 0)));
}

TEST(SpringForce, of_a_spring_without_length_is_zero_rather_than_not_a_number) {
  EXPECT_EQ(forces_of(one_spring(10, 2), Matrix3Xd::Ones(3, 2)).norm(), 0);
}

double energy(const SpringNetwork& network, const Matrix3Xd& x) {
  double sum = 0;
  for (const SpringSet* set : {&network.stretch, &network.shear, &network.bend})
    for (const Spring& spring : set->springs) {
      const double elongation = (x.col(spring.b) - x.col(spring.a)).norm() - spring.rest_length_m;
      sum += set->resistance / 2 * elongation * elongation;
    }
  return sum;
}

// A crumpled band, longer than one range of particles.
struct CrumpledBand {
  RibbonGrid grid{300, 4};
  SpringNetwork network = spring_network(grid, 30, 0.3, {.stretch = 10, .shear = 7, .bend = 3});
  Matrix3Xd positions = Matrix3Xd(3, grid.particle_count());

  CrumpledBand() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> away(-0.04, 0.04);
    for (int p = 0; p < grid.particle_count(); ++p)
      positions.col(p) << 0.1 * grid.row(p) + away(random), 0.1 * grid.column(p) + away(random),
          away(random);
  }
};

TEST(SpringForce, returns_the_elastic_energy) {
  const CrumpledBand band;
  SpringForces springs(band.network, band.grid.particle_count());
  Eigen::MatrixX3d forces;
  const double energy_j = springs.forces(band.positions.transpose(), forces);
  EXPECT_NEAR(energy_j / energy(band.network, band.positions), 1, 1e-14);
}

TEST(SpringForce, is_the_negative_slope_of_the_elastic_energy) {
  const CrumpledBand band;
  const Matrix3Xd forces = forces_of(band.network, band.positions);
  const double h = 1e-6;
  const auto at = [&](Eigen::Index i, double displacement_m) {
    Matrix3Xd displaced = band.positions;
    displaced.reshaped()[i] += displacement_m;
    return energy(band.network, displaced);
  };
  for (Eigen::Index i = 0; i < forces.size(); i += 7)
    EXPECT_NEAR(forces.reshaped()[i], -(at(i, h) - at(i, -h)) / (2 * h), 1e-7) << i;
}

TEST(SpringForce, adds_springs_that_join_the_same_particles) {
  SpringNetwork network = one_spring(10, 2);
  network.stretch.springs.push_back({1, 0, 3});
  Matrix3Xd positions = Matrix3Xd::Zero(3, 2);
  positions(0, 1) = 4;
  // By hand: 10 (4 - 2) + 10 (4 - 3) N.
  EXPECT_EQ(forces_of(network, positions).col(0), Eigen::Vector3d(30, 0, 0));
  // Of the same length, too: 10 (4 - 2) N more.
  network.stretch.springs.push_back({0, 1, 2});
  EXPECT_EQ(forces_of(network, positions).col(0), Eigen::Vector3d(50, 0, 0));
}

TEST(SpringForce, of_a_spring_too_short_for_squares_is_never_more_than_of_none_left) {
  for (const double length_m : {1e-140, 1e-155, 1e-170, 1e-310}) {
    Matrix3Xd positions = Matrix3Xd::Zero(3, 2);
    positions(0, 1) = length_m;
    EXPECT_LE(forces_of(one_spring(10, 2), positions).norm(), 20 * std::sqrt(2) * (1 + 1e-15));
  }
}

TEST(FastestFrequency, of_two_particles_on_a_spring_bounds_the_true_one) {
  // By hand: two masses m on a spring k swing at sqrt(2 k / m).
  EXPECT_GE(fastest_frequency(one_spring(8, 1), 2, 2), std::sqrt(8.0));
  EXPECT_LE(fastest_frequency(one_spring(8, 1), 2, 2), 1.01 * std::sqrt(8.0));
}

}  // namespace ribbon::spring_force_test
