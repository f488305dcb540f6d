#include "simulation/spring_metric.h"

#include <gtest/gtest.h>

#include <random>

namespace ribbon {
namespace {

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

MatrixX3d some_forces(int particle_count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> force(-1, 1);
  MatrixX3d forces(particle_count, 3);
  for (double& value : forces.reshaped()) value = force(random);
  return forces;
}

TEST(SpringMetric, solves_for_the_displacement_of_forces) {
  for (const RibbonGrid grid : {RibbonGrid{30, 4}, RibbonGrid{12, 20}}) {  // narrow and wide
    const SpringNetwork network = spring_network(grid, 1, 1, {.stretch = 9, .shear = 5, .bend = 2});
    const MatrixX3d forces = some_forces(grid.particle_count());
    MatrixX3d displacement;
    SpringMetric(network, grid.particle_count(), 0.25).solve(forces, displacement);
    const MatrixX3d back = metric_of(network, grid.particle_count(), 0.25) * displacement;
    EXPECT_LT((back - forces).norm(), 1e-12);
  }
}

TEST(SpringMetric, of_inertia_that_rounding_would_lose_still_solves) {
  const RibbonGrid grid{50, 4};
  const SpringNetwork network = spring_network(grid, 1, 1, {.stretch = 1e12});
  const MatrixX3d forces = some_forces(grid.particle_count());
  MatrixX3d displacement;
  SpringMetric(network, grid.particle_count(), 1e-20).solve(forces, displacement);
  EXPECT_TRUE(displacement.allFinite());
  EXPECT_GT(forces.cwiseProduct(displacement).sum(), 0);  // it leads downhill
}

}  // namespace
}  // namespace ribbon
