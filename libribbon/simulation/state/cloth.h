// The moving ribbon.
#pragma once

#include <Eigen/Core>

#include "simulation/state/state_archive.h"

namespace ribbon {

// Where the particles are and how they move. Columns are particles, then, in `positions` only, the
// vertices of the obstacle, which never move: collision tests see one set of vertices.
struct Cloth {
  Eigen::Matrix3Xd positions;   // 3 x (particles + obstacle vertices), metres
  Eigen::Matrix3Xd velocities;  // 3 x particles, m/s
  double particle_mass_kg = 0;

  [[nodiscard]] Eigen::Index particle_count() const { return velocities.cols(); }
  // 1/m of a vertex: the obstacle's are boundlessly heavy (paper, section 5.1).
  [[nodiscard]] double inverse_mass(int vertex) const {
    return vertex < particle_count() ? 1 / particle_mass_kg : 0.0;
  }

  void visit_state(StateArchive& archive) {
    auto& [positions_now, velocities_now, mass_of_the_scene] = *this;
    archive.visit(positions_now.leftCols(particle_count()));
    archive.visit(velocities_now);
  }
};

}  // namespace ribbon
