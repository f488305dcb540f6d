#include "simulation/start/dynamic_relaxation.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "geometry/vectors.h"
#include "ribbon_mesh/springs.h"
#include "simulation/integration/ordered_sums.h"
#include "simulation/integration/spring_forces.h"
#include "simulation/state/edge_strain.h"
#include "simulation/step/gated_step.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr int most_relaxing_steps = 60;
constexpr double longest_step_s = 0.01;
// Of the fastest swing: so that what stiff cloth lets go does not pass many edges in a step.
constexpr double most_radians_in_a_step = 25;
constexpr double slight_strain = 0.01;
constexpr double farthest = 0.5;      // of the width
constexpr double energy_left = 0.01;  // of the most kinetic energy

Scene of_springs_alone(Scene scene, double fastest_rad_s) {
  scene.time.integrator = IntegrationMethod::symplectic_euler;
  scene.time.step_s = std::min(longest_step_s, most_radians_in_a_step / fastest_rad_s);
  scene.gravity_m_s2.reset();
  scene.air_resistance_per_s = 0;
  scene.friction = 0;
  return scene;
}

bool any_farther(const Matrix3Xd& from, double distance_m, const Matrix3Xd& positions) {
  for (Eigen::Index particle = 0; particle < positions.cols(); ++particle)
    if (length_of(positions.col(particle) - from.col(particle)) > distance_m) return true;
  return false;
}

}  // namespace

int relax(const Scene& scene, const RestSize& size, const ContactLengths& lengths, Bodies& bodies,
          Cloth& cloth) {
  assert(scene.contact == ContactMethod::gate);
  const SpringNetwork springs = spring_network(size, scene.springs);
  if (worst_strain(springs, cloth.positions) <= slight_strain) return 0;
  const double fastest_rad_s = fastest_frequency(springs, cloth.particle_mass_kg, cloth.lightness);
  GatedStep step(of_springs_alone(scene, fastest_rad_s), size, lengths, cloth.particle_mass_kg);
  const Matrix3Xd drawn = cloth.positions;
  double energy = 0;  // kinetic, as if all particles weighed the same, but for a factor
  double most_energy = 0;
  int steps = 0;
  while (steps < most_relaxing_steps) {
    step.take(nullptr, bodies, cloth);
    ++steps;
    if (any_farther(drawn, farthest * size.width_m, cloth.positions)) break;
    const double* velocities = cloth.velocities.data();
    const double energy_before =
        std::exchange(energy, sum_of_products(velocities, velocities, cloth.velocities.size()));
    most_energy = std::max(most_energy, energy);
    if (energy >= energy_before) continue;
    if (energy <= energy_left * most_energy) break;
    cloth.velocities.setZero();
    energy = 0;
  }
  cloth.velocities.setZero();
  return steps;
}

}  // namespace ribbon
