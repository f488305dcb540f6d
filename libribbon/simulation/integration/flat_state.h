// Positions, velocities and the fastening force of a step, as integrators compute with them: one
// flat column for each axis.
#pragma once

#include <Eigen/Core>

#include "simulation/state/cloth.h"

namespace ribbon {

// Of all entries.
inline double dot(const Eigen::MatrixX3d& a, const Eigen::MatrixX3d& b) {
  return a.cwiseProduct(b).sum();
}

struct FlatState {
  Eigen::MatrixX3d positions;   // particles x 3, m
  Eigen::MatrixX3d velocities;  // particles x 3, m/s
  Eigen::MatrixX3d pull;        // particles x 3, N/kg, or no rows without a fastening force

  void take(const Eigen::Matrix3Xd& fastening_force, const Cloth& cloth) {
    positions = cloth.positions.leftCols(cloth.particle_count()).transpose();
    velocities = cloth.velocities.transpose();
    pull = fastening_force.transpose() / cloth.particle_mass_kg;
  }

  void give(Cloth& cloth) const {
    cloth.positions.leftCols(cloth.particle_count()) = positions.transpose();
    cloth.velocities = velocities.transpose();
  }
};

}  // namespace ribbon
