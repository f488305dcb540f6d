// The moving ribbon.
#pragma once

#include <Eigen/Core>

#include "simulation/state/state_archive.h"

namespace ribbon {

// Where the particles are and how they move.
struct Cloth {
  Eigen::Matrix3Xd positions;   // 3 x particles, metres
  Eigen::Matrix3Xd velocities;  // 3 x particles, m/s
  double particle_mass_kg = 0;

  [[nodiscard]] Eigen::Index particle_count() const { return velocities.cols(); }

  void visit_state(StateArchive& archive) {
    auto& [positions_now, velocities_now, mass_of_the_scene] = *this;
    archive.visit(positions_now);
    archive.visit(velocities_now);
  }
};

}  // namespace ribbon
