#include "simulation/spring_force.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

void add_forces(const SpringSet& set, const Matrix3Xd& positions, Matrix3Xd& forces) {
  for (const Spring& spring : set.springs) {
    const Vector3d from_a = positions.col(spring.b) - positions.col(spring.a);
    const double length_m = from_a.norm();
    if (length_m == 0) continue;  // no direction to push in
    const Vector3d pull = set.resistance * (length_m - spring.rest_length_m) / length_m * from_a;
    forces.col(spring.a) += pull;
    forces.col(spring.b) -= pull;
  }
}

double worst_strain(const SpringSet& set, const Matrix3Xd& positions) {
  double worst = 0;
  for (const Spring& spring : set.springs) {
    const double length_m = (positions.col(spring.b) - positions.col(spring.a)).norm();
    worst = std::max(worst, std::abs(length_m / spring.rest_length_m - 1));
  }
  return worst;
}

void add_resistances(const SpringSet& set, std::vector<double>& sums) {
  for (const Spring& spring : set.springs) {
    sums[static_cast<std::size_t>(spring.a)] += set.resistance;
    sums[static_cast<std::size_t>(spring.b)] += set.resistance;
  }
}

}  // namespace

void add_spring_forces(const SpringNetwork& network, const Matrix3Xd& positions,
                       Matrix3Xd& forces) {
  add_forces(network.stretch, positions, forces);
  add_forces(network.shear, positions, forces);
  add_forces(network.bend, positions, forces);
}

double worst_strain(const SpringNetwork& network, const Matrix3Xd& positions) {
  return std::max(worst_strain(network.stretch, positions), worst_strain(network.shear, positions));
}

double fastest_frequency(const SpringNetwork& network, int particle_count,
                         double particle_mass_kg) {
  std::vector<double> sums(static_cast<std::size_t>(particle_count), 0.0);
  add_resistances(network.stretch, sums);
  add_resistances(network.shear, sums);
  add_resistances(network.bend, sums);
  // Gershgorin: no eigenvalue of the stiffness exceeds twice the largest sum at one particle.
  return std::sqrt(2 * *std::max_element(sums.begin(), sums.end()) / particle_mass_kg);
}

}  // namespace ribbon
