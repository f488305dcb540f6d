#include "simulation/integration/spring_damping.h"

#include <cmath>

namespace ribbon {

namespace {

using Eigen::Vector3d;

// Reduces the speed along the spring by `lost`, a fraction; each end takes half of the impulse.
void damp(int a, int b, double lost, Cloth& cloth) {
  const Vector3d along = cloth.positions.col(b) - cloth.positions.col(a);
  const double squared = along.squaredNorm();
  if (squared == 0) return;  // no direction
  const Vector3d parting = cloth.velocities.col(b) - cloth.velocities.col(a);
  const Vector3d half = 0.5 * lost * along.dot(parting) / squared * along;
  cloth.velocities.col(a) += half;
  cloth.velocities.col(b) -= half;
}

}  // namespace

void SpringDamping::apply(double h, Cloth& cloth) const {
  for (const SpringKind* kind : network_.kinds()) {
    if (kind->stiffness == 0) continue;
    const double r = 2 * network_.damping * std::sqrt(2 * kind->stiffness / particle_mass_kg_) * h;
    for (const SpringFamily& family : kind->families)
      for_each_spring(network_.grid, family, [&](int a, int b) { damp(a, b, r / (1 + r), cloth); });
  }
}

}  // namespace ribbon
