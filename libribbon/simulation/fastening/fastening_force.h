// The pre-step fastening force (paper, section 5.2, Figure 6, footnote 2).
#pragma once

#include <Eigen/Core>

#include "geometry/ribbon_grid.h"
#include "scene/scene.h"
#include "simulation/state/state_archive.h"

namespace ribbon {

// Moves particles toward their end of the ribbon: the first half of the rows toward the first end,
// the second half toward the second. The force points along the smoothed direction of the ribbon
// (averaged over as many rows to either side as the ribbon is particles wide, so that it fades
// where the ribbon is crumpled).
//
// Distributed, it is proportional to the particle's distance from the centre axis. By its ends, it
// acts on the last rows only, as many as the ribbon is particles wide, and is the same everywhere:
// so strong that each end draws its half of the ribbon against the air at the scene's speed.
class FasteningForce {
 public:
  // start: 3 x at least all particles, the ribbon at the start, whose mean distance from the axis
  // is where the scene's speed holds for a distributed force.
  FasteningForce(const FasteningScene& scene, double air_resistance_per_s, const RibbonGrid& grid,
                 const Eigen::Matrix3Xd& start, double particle_mass_kg);

  // 3 x particles, N.
  [[nodiscard]] Eigen::Matrix3Xd at(const Eigen::Matrix3Xd& positions) const;

  // The force on a particle for each m/s at which the scene wants it to move, N s/m.
  [[nodiscard]] double newton_per_m_s() const { return newton_per_m_s_; }

  void visit_state(StateArchive& archive);

 private:
  [[nodiscard]] double distance_from_axis_m(const Eigen::Vector3d& position) const;
  [[nodiscard]] double strength_n(int particle, const Eigen::Vector3d& position) const;
  // Distributed, on a particle for each metre between it and the axis.
  [[nodiscard]] double newton_per_m() const;

  FasteningPull pull_;
  RibbonGrid grid_;
  Eigen::Vector3d axis_point_m_;
  Eigen::Vector3d axis_direction_;
  int held_rows_;  // at each end, when pulled by the ends
  double newton_per_m_s_;
  double speed_m_s_;
  double mean_distance_m_ = 0;  // from the axis, at the start
};

}  // namespace ribbon
