// The moving ribbon.
#pragma once

#include <Eigen/Core>

#include "geometry/rest_size.h"
#include "simulation/state/state_archive.h"

namespace ribbon {

// Where the particles are and how they move.
struct Cloth {
  Eigen::Matrix3Xd positions;     // 3 x particles, metres
  Eigen::Matrix3Xd velocities;    // 3 x particles, m/s
  double particle_mass_kg = 0;    // mean
  Eigen::ArrayXd lightness = {};  // of each particle: the mean mass over its own; empty: all weigh
                                  // the same

  // 1/kg.
  [[nodiscard]] double inverse_mass(int particle) const {
    return (lightness.size() == 0 ? 1 : lightness[particle]) / particle_mass_kg;
  }
  [[nodiscard]] Eigen::Index particle_count() const { return velocities.cols(); }

  // To the 24 bits of single precision, at any speed: finer than a step's motion is known, and what
  // a checkpoint would spend on the other 29 is noise that nothing compresses.
  void round_velocities();

  void visit_state(StateArchive& archive) {
    auto& [positions_now, velocities_now, mass_of_the_scene, lightness_of_the_size] = *this;
    archive.visit(positions_now);
    archive.visit(velocities_now);
  }
};

// Cloth::lightness of a band that weighs the same everywhere for its area.
Eigen::ArrayXd lightness(const RestSize& size);

}  // namespace ribbon
