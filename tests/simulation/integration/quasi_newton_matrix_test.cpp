#include "simulation/integration/quasi_newton_matrix.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <random>

#include "parallel/any_threads.h"
#include "simulation/integration/spring_networks.h"

namespace ribbon::quasi_newton_matrix_test {

using Eigen::MatrixX3d;
using Eigen::MatrixXd;

SpringNetwork network_of(const RibbonGrid& grid) {
  return spring_network({grid, 1, 1}, {.stretch = 9, .shear = 5, .bend = 2});
}

void add_spring(double stiffness, int a, int b, MatrixXd& matrix) {
  matrix(a, a) += stiffness;
  matrix(b, b) += stiffness;
  matrix(a, b) -= stiffness;
  matrix(b, a) -= stiffness;
}

// Written out in full, from the definition.
MatrixXd matrix_of(const SpringNetwork& network, double inertia) {
  const int count = network.grid.particle_count();
  MatrixXd matrix = inertia * MatrixXd::Identity(count, count);
  for_each_spring(network, [&](int a, int b, double, double stiffness) {
    add_spring(stiffness, a, b, matrix);
  });
  return matrix;
}

// What mirroring adds: at both selvages a spring for each that would reach over it.
MatrixXd mirrored_matrix_of(const SpringNetwork& network, double inertia) {
  const RibbonGrid& grid = network.grid;
  MatrixXd matrix = matrix_of(network, inertia);
  for (int row = 0; row < grid.along; ++row)
    for (const int side : {0, grid.across - 1}) {
      const int particle = grid.particle(row, side);
      add_spring(network.bend.stiffness, particle, side == 0 ? particle + 1 : particle - 1, matrix);
      if (row + 1 < grid.along)
        add_spring(network.shear.stiffness, particle, particle + grid.across, matrix);
    }
  return matrix;
}

MatrixX3d some_forces(int particle_count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> force(-1, 1);
  MatrixX3d forces(particle_count, 3);
  for (double& value : forces.reshaped()) value = force(random);
  return forces;
}

MatrixX3d solved(const SpringNetwork& network, double inertia) {
  MatrixX3d displacement;
  QuasiNewtonMatrix(network, inertia)
      .solve(some_forces(network.grid.particle_count()), displacement);
  return displacement;
}

TEST(QuasiNewtonMatrix, solves_for_the_displacement_of_forces) {
  for (const RibbonGrid grid : {RibbonGrid{30, 4}, RibbonGrid{12, 20}, RibbonGrid{3, 3}}) {
    const SpringNetwork network = network_of(grid);
    const MatrixX3d forces = some_forces(grid.particle_count());
    const MatrixX3d expected = mirrored_matrix_of(network, 0.25).ldlt().solve(forces);
    EXPECT_LT((solved(network, 0.25) - expected).norm(), 1e-11);
  }
}

TEST(QuasiNewtonMatrix, heeds_that_rows_weigh_differently) {
  const RibbonGrid grid{12, 5};
  const SpringNetwork network = network_of(grid);
  const Eigen::ArrayXd heaviness = Eigen::ArrayXd::LinSpaced(grid.along, 0.5, 1.5);
  MatrixXd matrix = mirrored_matrix_of(network, 0);
  for (int p = 0; p < grid.particle_count(); ++p) matrix(p, p) += 0.25 * heaviness[grid.row(p)];
  const MatrixX3d forces = some_forces(grid.particle_count());
  MatrixX3d displacement;
  QuasiNewtonMatrix(network, 0.25, heaviness).solve(forces, displacement);
  EXPECT_LT((displacement - matrix.ldlt().solve(forces)).norm(), 1e-11);
}

TEST(QuasiNewtonMatrix, costs_no_less_than_the_network) {
  const SpringNetwork network = network_of({9, 6});
  const MatrixXd excess = mirrored_matrix_of(network, 0.25) - matrix_of(network, 0.25);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<MatrixXd>(excess).eigenvalues().minCoeff(), -1e-12);
}

TEST(QuasiNewtonMatrix, of_the_narrowest_ribbons_leads_downhill) {
  for (const RibbonGrid grid : {RibbonGrid{2, 2}, RibbonGrid{2, 5}, RibbonGrid{5, 2}}) {
    const MatrixX3d displacement = solved(network_of(grid), 0.25);
    EXPECT_GT(some_forces(grid.particle_count()).cwiseProduct(displacement).sum(), 0);
  }
}

TEST(QuasiNewtonMatrix, of_inertia_that_rounding_would_lose_still_solves) {
  const RibbonGrid grid{50, 4};
  const MatrixX3d displacement = solved(spring_network({grid, 1, 1}, {.stretch = 1e12}), 1e-20);
  EXPECT_TRUE(displacement.allFinite());
  EXPECT_GT(some_forces(grid.particle_count()).cwiseProduct(displacement).sum(), 0);
}

TEST(QuasiNewtonMatrix, gives_the_same_bits_for_any_number_of_threads) {
  const SpringNetwork network = network_of({80, 16});
  same_for_any_threads([&] { return solved(network, 0.25); });
}

}  // namespace ribbon::quasi_newton_matrix_test
