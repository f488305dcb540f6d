#include "simulation/integration/spring_metric.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <random>

#include "parallel/parallel.h"

namespace ribbon::spring_metric_test {

using Eigen::MatrixX3d;
using Eigen::MatrixXd;

// Written out in full, from the definition.
MatrixXd metric_of(const SpringNetwork& network, int particle_count, double inertia) {
  MatrixXd metric = inertia * MatrixXd::Identity(particle_count, particle_count);
  for (const SpringSet* set : {&network.stretch, &network.shear, &network.bend})
    for (const Spring& spring : set->springs) {
      metric(spring.a, spring.a) += set->resistance;
      metric(spring.b, spring.b) += set->resistance;
      metric(spring.a, spring.b) -= set->resistance;
      metric(spring.b, spring.a) -= set->resistance;
    }
  return metric;
}

// What mirroring adds: at both selvages a spring for each that would reach over it.
MatrixXd mirrored_metric_of(const SpringNetwork& network, const RibbonGrid& grid, double inertia) {
  MatrixXd metric = metric_of(network, grid.particle_count(), inertia);
  const auto add = [&](double resistance, int a, int b) {
    metric(a, a) += resistance;
    metric(b, b) += resistance;
    metric(a, b) -= resistance;
    metric(b, a) -= resistance;
  };
  for (int row = 0; row < grid.along; ++row)
    for (const int side : {0, grid.across - 1}) {
      const int inner = side == 0 ? 1 : grid.across - 2;
      add(network.bend.resistance, grid.particle(row, side), grid.particle(row, inner));
      if (row + 1 < grid.along)
        add(network.shear.resistance, grid.particle(row, side), grid.particle(row + 1, side));
    }
  return metric;
}

MatrixX3d some_forces(int particle_count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> force(-1, 1);
  MatrixX3d forces(particle_count, 3);
  for (double& value : forces.reshaped()) value = force(random);
  return forces;
}

MatrixX3d solved(const SpringNetwork& network, const RibbonGrid& grid, double inertia) {
  MatrixX3d displacement;
  SpringMetric(network, grid, inertia).solve(some_forces(grid.particle_count()), displacement);
  return displacement;
}

TEST(SpringMetric, solves_for_the_displacement_of_forces) {
  const SpringScene resistances{.stretch = 9, .shear = 5, .bend = 2};
  for (const RibbonGrid grid : {RibbonGrid{30, 4}, RibbonGrid{12, 20}, RibbonGrid{3, 3}}) {
    const SpringNetwork network = spring_network(grid, 1, 1, resistances);
    const MatrixX3d forces = some_forces(grid.particle_count());
    const MatrixX3d expected = mirrored_metric_of(network, grid, 0.25).ldlt().solve(forces);
    EXPECT_LT((solved(network, grid, 0.25) - expected).norm(), 1e-11);
  }
}

TEST(SpringMetric, costs_no_less_than_the_network) {
  const RibbonGrid grid{9, 6};
  const SpringNetwork network = spring_network(grid, 1, 1, {.stretch = 9, .shear = 5, .bend = 2});
  const MatrixXd excess =
      mirrored_metric_of(network, grid, 0.25) - metric_of(network, grid.particle_count(), 0.25);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<MatrixXd>(excess).eigenvalues().minCoeff(), -1e-12);
}

TEST(SpringMetric, of_the_narrowest_ribbons_leads_downhill) {
  for (const RibbonGrid grid : {RibbonGrid{2, 2}, RibbonGrid{2, 5}, RibbonGrid{5, 2}}) {
    const SpringNetwork network = spring_network(grid, 1, 1, {.stretch = 9, .shear = 5, .bend = 2});
    const MatrixX3d displacement = solved(network, grid, 0.25);
    EXPECT_GT(some_forces(grid.particle_count()).cwiseProduct(displacement).sum(), 0);
  }
}

TEST(SpringMetric, of_inertia_that_rounding_would_lose_still_solves) {
  const RibbonGrid grid{50, 4};
  const SpringNetwork network = spring_network(grid, 1, 1, {.stretch = 1e12});
  const MatrixX3d displacement = solved(network, grid, 1e-20);
  EXPECT_TRUE(displacement.allFinite());
  EXPECT_GT(some_forces(grid.particle_count()).cwiseProduct(displacement).sum(), 0);
}

TEST(SpringMetric, gives_the_same_bits_for_any_number_of_threads) {
  const RibbonGrid grid{80, 16};
  const SpringNetwork network = spring_network(grid, 1, 1, {.stretch = 9, .shear = 5, .bend = 2});
  set_thread_limit(1);
  const MatrixX3d alone = solved(network, grid, 0.25);
  set_thread_limit(0);
  EXPECT_EQ(solved(network, grid, 0.25), alone);
}

}  // namespace ribbon::spring_metric_test
