// The pre-step fastening force (paper, section 5.2, Figure 6, footnote 2).
#pragma once

#include <Eigen/Core>

#include "geometry/ribbon_grid.h"
#include "scene/scene.h"

namespace ribbon {

// Moves every particle toward its end of the ribbon: the first half of the rows toward the first
// end, the second half toward the second. The force points along the smoothed direction of the
// ribbon (averaged over as many rows to either side as the ribbon is particles wide, so that it
// fades where the ribbon is crumpled) and is proportional to the particle's distance from the
// centre axis.
class FasteningForce {
 public:
  // start: 3 x at least all particles, the ribbon at the start, whose mean distance from the axis
  // is where the scene's speed holds.
  FasteningForce(const FasteningScene& scene, double air_resistance_per_s, const RibbonGrid& grid,
                 const Eigen::Matrix3Xd& start, double particle_mass_kg);

  // 3 x particles, N.
  [[nodiscard]] Eigen::Matrix3Xd at(const Eigen::Matrix3Xd& positions) const;

 private:
  [[nodiscard]] double distance_from_axis_m(const Eigen::Vector3d& position) const;

  RibbonGrid grid_;
  Eigen::Vector3d axis_point_m_;
  Eigen::Vector3d axis_direction_;
  double newton_per_m_ = 0;  // force on a particle per distance from the axis
};

}  // namespace ribbon
