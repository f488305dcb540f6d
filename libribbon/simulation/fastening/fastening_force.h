// The pre-step fastening force (paper, section 5.2, Figure 6).
#pragma once

#include <Eigen/Core>
#include <array>

#include "geometry/rest_size.h"
#include "scene/scene.h"
#include "simulation/state/smoothed_tangents.h"
#include "simulation/state/state_archive.h"

namespace ribbon {

// Pulls every particle toward the end of the ribbon that its half belongs to. Footnote 2 of the
// paper: on a particle of row i it is f_i in the second half and -f_i in the first,
//
//   f_i = sum of (P_j - P_j-1) / sum of |P_j - P_j-1| * l_i,  j = i - m ... i + m,
//
// where m is the number of particles across. The quotient is the smoothed tangent, which is short
// where the ribbon is crumpled. The strength l_i is proportional to the distance from the centre
// axis.
//
// Beside the paper, pull = "ends": the force acts on the last m rows alone, with one strength, so
// that each end draws its half of the ribbon against the air at the scene's speed.
//
// Where rows weigh differently, both halves, or both ends, are pulled as hard as those of a ribbon
// of mean width: otherwise the heavier half would draw a tight ribbon through its knot.
class FasteningForce {
 public:
  // particle_mass_kg: mean. start: 3 x particles, the ribbon at the start, whose mean distance from
  // the axis is where the scene's speed holds.
  FasteningForce(const FasteningScene& scene, double air_resistance_per_s, const RestSize& size,
                 const Eigen::Matrix3Xd& start, double particle_mass_kg);

  // 3 x particles, N, of particles of mean mass.
  const Eigen::Matrix3Xd& at(const Eigen::Matrix3Xd& positions);

  // The force on a particle for each m/s at which the scene wants it to move, N s/m.
  [[nodiscard]] double newton_per_m_s() const { return newton_per_m_s_; }

  void visit_state(StateArchive& archive);

 private:
  [[nodiscard]] double distance_from_axis_m(const Eigen::Vector3d& position) const;
  // l_i above, N.
  [[nodiscard]] double strength_n(int particle, const Eigen::Vector3d& position) const;

  FasteningScene scene_;
  RibbonGrid grid_;
  int held_rows_;  // at each end, when pulled by the ends
  double newton_per_m_s_;
  std::array<double, 2> weakened_;  // the pull on the first half and on the second, times this
  double mean_distance_m_ = 0;      // from the axis, at the start
  SmoothedTangents tangents_;
  Eigen::Matrix3Xd forces_;
};

}  // namespace ribbon
