#include "simulation/integration/quasi_newton_matrix.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <cstdlib>
#include <random>

#include "parallel/any_instructions.h"
#include "parallel/any_threads.h"
#include "simulation/integration/spring_networks.h"

namespace ribbon::quasi_newton_matrix_test {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixX3d;
using Eigen::MatrixXd;
using Eigen::RowVector3d;

SpringNetwork network_of(const RibbonGrid& grid) {
  return spring_network({grid, 1, 1}, {.stretch = 9, .shear = 5, .bend = 2});
}

MatrixX3d some_numbers(int particle_count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(-1, 1);
  MatrixX3d numbers(particle_count, 3);
  for (double& value : numbers.reshaped()) value = between(random);
  return numbers;
}

MatrixX3d some_forces(const RibbonGrid& grid) {
  return some_numbers(grid.particle_count(), 5);
}

// A ribbon along a helix, crumpled besides.
MatrixX3d crumpled(const RibbonGrid& grid) {
  MatrixX3d positions = 0.4 * some_numbers(grid.particle_count(), 6);
  for (int p = 0; p < grid.particle_count(); ++p) {
    const double turn = 0.1 * grid.row(p);
    positions.row(p) +=
        RowVector3d(8 * std::cos(turn), 8 * std::sin(turn), turn + 0.7 * grid.column(p));
  }
  return positions;
}

Matrix3d resistance(const RowVector3d& spring) {
  const RowVector3d along = spring.normalized();
  return 0.05 * Matrix3d::Identity() + 0.95 * along.transpose() * along;
}

// Of all springs that lead from a row to another so many rows on, as many columns to the one side
// or to the other.
Matrix3d mean_resistance(const RibbonGrid& grid, int row, int rows, int columns,
                         const MatrixX3d& positions) {
  Matrix3d sum = Matrix3d::Zero();
  int count = 0;
  for (int column = 0; column < grid.across; ++column)
    for (const int other : {column - columns, column + columns}) {
      if (other < 0 || other >= grid.across) continue;
      sum += resistance(positions.row(grid.particle(row + rows, other)) -
                        positions.row(grid.particle(row, column)));
      ++count;
    }
  return sum / count;
}

void add_spring(const Matrix3d& resistance, int a, int b, MatrixXd& matrix) {
  const Index i = 3 * Index{a};
  const Index j = 3 * Index{b};
  matrix.block<3, 3>(i, i) += resistance;
  matrix.block<3, 3>(j, j) += resistance;
  matrix.block<3, 3>(i, j) -= resistance;
  matrix.block<3, 3>(j, i) -= resistance;
}

// Written out in full, from the definition.
MatrixXd matrix_of(const SpringNetwork& network, const MatrixX3d& positions, double inertia) {
  const RibbonGrid& grid = network.grid;
  const Index size = 3 * Index{grid.particle_count()};
  MatrixXd matrix = inertia * MatrixXd::Identity(size, size);
  for_each_spring(network, [&](int a, int b, double, double stiffness) {
    const int row = grid.row(a);
    const int columns = std::abs(grid.column(a) - grid.column(b));
    add_spring(stiffness * mean_resistance(grid, row, grid.row(b) - row, columns, positions), a, b,
               matrix);
  });
  // What mirroring adds: at both selvages a spring for each that would reach over it.
  for (int row = 0; row < grid.along; ++row)
    for (const int side : {0, grid.across - 1}) {
      const int particle = grid.particle(row, side);
      add_spring(network.bend.stiffness * mean_resistance(grid, row, 0, 2, positions), particle,
                 side == 0 ? particle + 1 : particle - 1, matrix);
      if (row + 1 < grid.along)
        add_spring(network.shear.stiffness * mean_resistance(grid, row, 1, 1, positions), particle,
                   particle + grid.across, matrix);
    }
  return matrix;
}

MatrixX3d solved(const MatrixXd& matrix, const MatrixX3d& forces) {
  const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> by_particle = forces;
  const Eigen::VectorXd x = matrix.ldlt().solve(by_particle.reshaped<Eigen::RowMajor>());
  return x.reshaped<Eigen::RowMajor>(forces.rows(), 3);
}

MatrixX3d solved(const SpringNetwork& network, const MatrixX3d& positions, double inertia) {
  QuasiNewtonMatrix matrix(network, inertia);
  matrix.factor(positions);
  MatrixX3d displacement;
  matrix.solve(some_forces(network.grid), displacement);
  return displacement;
}

void expect_downhill(const RibbonGrid& grid, const MatrixX3d& displacement) {
  EXPECT_TRUE(displacement.allFinite());
  EXPECT_GT(some_forces(grid).cwiseProduct(displacement).sum(), 0);
}

TEST(QuasiNewtonMatrix, solves_for_the_displacement_of_forces) {
  for (const RibbonGrid grid : {RibbonGrid{30, 4}, RibbonGrid{9, 13}, RibbonGrid{3, 3}}) {
    const SpringNetwork network = network_of(grid);
    const MatrixX3d positions = crumpled(grid);
    const MatrixXd matrix = matrix_of(network, positions, 0.25);
    EXPECT_LT((solved(network, positions, 0.25) - solved(matrix, some_forces(grid))).norm(), 1e-11);
  }
}

TEST(QuasiNewtonMatrix, takes_springs_as_they_lie_each_time) {
  const RibbonGrid grid{12, 5};
  const SpringNetwork network = network_of(grid);
  QuasiNewtonMatrix matrix(network, 0.25);
  matrix.factor(some_numbers(grid.particle_count(), 8));
  matrix.factor(crumpled(grid));
  MatrixX3d displacement;
  matrix.solve(some_forces(grid), displacement);
  EXPECT_EQ(displacement, solved(network, crumpled(grid), 0.25));
}

TEST(QuasiNewtonMatrix, heeds_that_rows_weigh_differently) {
  const RibbonGrid grid{12, 5};
  const SpringNetwork network = network_of(grid);
  const Eigen::ArrayXd heaviness = Eigen::ArrayXd::LinSpaced(grid.along, 0.5, 1.5);
  MatrixXd matrix = matrix_of(network, crumpled(grid), 0);
  for (Index i = 0; i < matrix.rows(); ++i)
    matrix(i, i) += 0.25 * heaviness[grid.row(static_cast<int>(i / 3))];
  QuasiNewtonMatrix under_test(network, 0.25, heaviness);
  under_test.factor(crumpled(grid));
  MatrixX3d displacement;
  under_test.solve(some_forces(grid), displacement);
  EXPECT_LT((displacement - solved(matrix, some_forces(grid))).norm(), 1e-11);
}

// A row whose particles are drawn each by itself, and two parts, which share a row, by their
// middles.
TEST(QuasiNewtonMatrix, heeds_what_holds_particles) {
  const RibbonGrid grid{12, 5};
  const SpringNetwork network = network_of(grid);
  const std::vector<double> whole{1};
  const std::vector<double> shares{0.1, 0.3, 0.2, 0.05, 0.25, 0.1};
  std::vector<SharedSpring> held{{{grid.particle(7, 1), shares}, 300},
                                 {{grid.particle(8, 0), shares}, 7}};
  for (int column = 0; column < grid.across; ++column)
    held.push_back({{grid.particle(3, column), whole}, 40});
  MatrixXd matrix = matrix_of(network, crumpled(grid), 0.25);
  for (const auto& [middle, stiffness] : held)
    for (std::size_t i = 0; i < middle.shares.size(); ++i)
      for (std::size_t j = 0; j < middle.shares.size(); ++j)
        for (Index axis = 0; axis < 3; ++axis)
          matrix(3 * (middle.first + static_cast<Index>(i)) + axis,
                 3 * (middle.first + static_cast<Index>(j)) + axis) +=
              middle.shares[i] * middle.shares[j] * stiffness;
  QuasiNewtonMatrix under_test(network, 0.25);
  MatrixX3d displacement;
  under_test.factor(crumpled(grid), held);
  under_test.solve(some_forces(grid), displacement);
  EXPECT_LT((displacement - solved(matrix, some_forces(grid))).norm(), 1e-11);
  // And no longer once they let go.
  under_test.factor(crumpled(grid));
  under_test.solve(some_forces(grid), displacement);
  EXPECT_EQ(displacement, solved(network, crumpled(grid), 0.25));
}

TEST(QuasiNewtonMatrix, of_the_narrowest_ribbons_leads_downhill) {
  for (const RibbonGrid grid : {RibbonGrid{2, 2}, RibbonGrid{2, 5}, RibbonGrid{5, 2}})
    expect_downhill(grid, solved(network_of(grid), crumpled(grid), 0.25));
}

TEST(QuasiNewtonMatrix, of_springs_without_length_leads_downhill) {
  const RibbonGrid grid{8, 4};
  for (const double scale : {0.0, 1e-170})
    expect_downhill(grid, solved(network_of(grid), scale * crumpled(grid), 0.25));
}

TEST(QuasiNewtonMatrix, of_inertia_that_rounding_would_lose_still_solves) {
  const RibbonGrid grid{50, 4};
  expect_downhill(grid,
                  solved(spring_network({grid, 1, 1}, {.stretch = 1e12}), crumpled(grid), 1e-20));
}

TEST(QuasiNewtonMatrix, gives_the_same_bits_for_any_threads_and_instructions) {
  const RibbonGrid grid{80, 16};
  const auto compute = [&] { return solved(network_of(grid), crumpled(grid), 0.25); };
  EXPECT_EQ(same_for_any_threads(compute), same_for_any_instructions(compute));
}

}  // namespace ribbon::quasi_newton_matrix_test
