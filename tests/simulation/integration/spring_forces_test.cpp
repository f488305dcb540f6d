#include "simulation/integration/spring_forces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "simulation/integration/spring_networks.h"

namespace ribbon::spring_forces_test {

using Eigen::Matrix3Xd;

Matrix3Xd forces_of(const SpringNetwork& network, const Matrix3Xd& positions) {
  Eigen::MatrixX3d forces;
  SpringForces(network).forces(positions.transpose(), forces);
  return forces.transpose();
}

// By hand: 3-4-5 triangle, length 5 at rest 2, elongation 3, stiffness 10: 30 N along (0.6, 0.8,
// 0).
TEST(SpringForces, are_stiffness_times_elongation_along_the_spring) {
  Matrix3Xd positions(3, 2);
  positions << 0, 3, 0, 4, 1, 1;
  const Matrix3Xd forces = forces_of(one_spring(10, 2), positions);
  EXPECT_TRUE(forces.col(0).isApprox(Eigen::Vector3d(18, 24, 0)));
  EXPECT_TRUE(forces.col(1).isApprox(Eigen::Vector3d(-18, -24, 0)));
}

TEST(SpringForces, of_a_spring_without_length_are_zero_rather_than_not_a_number) {
  EXPECT_EQ(forces_of(one_spring(10, 2), Matrix3Xd::Ones(3, 2)).norm(), 0);
}

TEST(SpringForces, are_not_computed_for_kinds_without_stiffness) {
  EXPECT_TRUE(SpringForces(one_spring(0, 2)).empty());
  EXPECT_FALSE(SpringForces(one_spring(1, 2)).empty());
}

// A crumpled band, longer than one range of particles.
struct CrumpledBand {
  RibbonGrid grid{300, 4};
  SpringNetwork network = spring_network({grid, 30, 0.3}, {.stretch = 10, .shear = 7, .bend = 3});
  Matrix3Xd positions = Matrix3Xd(3, grid.particle_count());

  CrumpledBand() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> away(-0.04, 0.04);
    for (int p = 0; p < grid.particle_count(); ++p)
      positions.col(p) << 0.1 * grid.row(p) + away(random), 0.1 * grid.column(p) + away(random),
          away(random);
  }
};

TEST(SpringForces, return_the_elastic_energy) {
  const CrumpledBand band;
  Eigen::MatrixX3d forces;
  const double energy_j =
      SpringForces(band.network).forces_and_energy(band.positions.transpose(), forces);
  EXPECT_NEAR(energy_j / elastic_energy_j(band.network, band.positions), 1, 1e-14);
  EXPECT_EQ(forces.transpose(), forces_of(band.network, band.positions));
}

TEST(SpringForces, of_slack_springs_are_a_fraction_and_so_is_the_energy) {
  const CrumpledBand band;
  SpringForces springs(band.network);
  Eigen::MatrixX3d all;
  Eigen::MatrixX3d some;
  const double all_j = springs.forces_and_energy(band.positions.transpose(), all);
  springs.slacken(0.25);
  EXPECT_EQ(springs.forces_and_energy(band.positions.transpose(), some), 0.25 * all_j);
  EXPECT_EQ(some, 0.25 * all);
  springs.forces(band.positions.transpose(), some);
  EXPECT_EQ(some, 0.25 * all);
}

TEST(SpringForces, are_the_negative_slope_of_the_elastic_energy) {
  const CrumpledBand band;
  const Matrix3Xd forces = forces_of(band.network, band.positions);
  const double h = 1e-6;
  const auto at = [&](Eigen::Index i, double displacement_m) {
    Matrix3Xd displaced = band.positions;
    displaced.reshaped()[i] += displacement_m;
    return elastic_energy_j(band.network, displaced);
  };
  for (Eigen::Index i = 0; i < forces.size(); i += 7)
    EXPECT_NEAR(forces.reshaped()[i], -(at(i, h) - at(i, -h)) / (2 * h), 1e-7) << i;
}

TEST(SpringForces, of_springs_that_join_the_same_particles_add_up) {
  SpringNetwork network = one_spring(10, 2);
  network.stretch.families[1] = {1, 0, 3};
  Matrix3Xd positions = Matrix3Xd::Zero(3, 2);
  positions(0, 1) = 4;
  // By hand: 10 (4 - 2) + 10 (4 - 3) N.
  EXPECT_EQ(forces_of(network, positions).col(0), Eigen::Vector3d(30, 0, 0));
  // Of the same length, too: 10 (4 - 2) N more.
  network.bend = one_spring(10, 2).stretch;
  EXPECT_EQ(forces_of(network, positions).col(0), Eigen::Vector3d(50, 0, 0));
}

TEST(SpringForces, of_a_spring_too_short_for_squares_are_never_more_than_of_none_left) {
  for (const double length_m : {1e-140, 1e-155, 1e-170, 1e-310}) {
    Matrix3Xd positions = Matrix3Xd::Zero(3, 2);
    positions(0, 1) = length_m;
    EXPECT_LE(forces_of(one_spring(10, 2), positions).norm(), 20 * std::sqrt(2) * (1 + 1e-15));
  }
}

// A network in which all springs lie in the direction of the motion: how fast its fastest swing is,
// by power iteration.
double fastest_in_line(const SpringNetwork& network) {
  Eigen::VectorXd swing(network.grid.particle_count());
  for (Eigen::Index p = 0; p < swing.size(); ++p)
    swing[p] = std::cos(1 + 3.7 * static_cast<double>(p * p));
  double stiffness = 0;
  for (int i = 0; i < 3000; ++i) {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(swing.size());
    for_each_spring(network, [&](int a, int b, double, double k) {
      forces[a] += k * (swing[a] - swing[b]);
      forces[b] += k * (swing[b] - swing[a]);
    });
    stiffness = forces.norm();
    swing = forces / stiffness;
  }
  return std::sqrt(stiffness);
}

TEST(FastestFrequency, bounds_that_of_springs_in_line_closely) {
  for (const double stretch : {0.0, 1.0, 10.0})
    for (const double shear : {0.0, 1.0, 10.0})
      for (const double bend : {0.0, 1.0, 10.0}) {
        if (stretch + shear + bend == 0) continue;
        const SpringNetwork network = spring_network(
            {{40, 30}, 1, 1}, {.stretch = stretch, .shear = shear, .bend = bend, .damping = 0});
        const double fastest = fastest_in_line(network);
        EXPECT_GE(fastest_frequency(network, 1), fastest) << stretch << shear << bend;
        EXPECT_LE(fastest_frequency(network, 1), 1.02 * fastest) << stretch << shear << bend;
      }
}

TEST(FastestFrequency, of_two_particles_on_a_spring_bounds_the_true_one) {
  // By hand: two masses m on a spring k swing at sqrt(2 k / m).
  EXPECT_GE(fastest_frequency(one_spring(8, 1), 2), std::sqrt(8.0));
  EXPECT_LE(fastest_frequency(one_spring(8, 1), 2), 1.01 * std::sqrt(8.0));
}

TEST(FastestFrequency, of_particles_that_weigh_differently_bounds_the_true_one) {
  // By hand: masses of 2 and 1/2 kg on a spring k swing at sqrt(k (1/2 + 2)).
  const Eigen::ArrayXd lightness = Eigen::Array2d(1, 4);
  EXPECT_GE(fastest_frequency(one_spring(8, 1), 2, lightness), std::sqrt(20.0));
  EXPECT_LE(fastest_frequency(one_spring(8, 1), 2, lightness), 2.01 * std::sqrt(8.0));
}

}  // namespace ribbon::spring_forces_test
