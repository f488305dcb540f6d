// How often does the ribbon go round an axis?
#pragma once

#include <Eigen/Core>
#include <array>

#include "exact/orientation.h"
#include "geometry/centre_axis.h"

namespace ribbon {

// Counts the turns of a curve that is closed by the trails of its two ends, back to the first
// frame, and by the straight line between them there. So the number stays when the ends travel
// round the axis, and changes only when the curve passes through it. The axis is endless. All tests
// are exact.
class AxisTurns {
 public:
  explicit AxisTurns(const CentreAxis& axis);

  // The next frame's curve, 3 x at least 2. Between two frames, the ends move straight.
  void follow(const Eigen::Matrix3Xd& curve);

  // Counter-clockwise looking against the direction of the axis.
  [[nodiscard]] int turns() const { return turns_; }
  // Has the curve, or the trail of an end, touched the axis in some frame?
  [[nodiscard]] bool met() const { return met_; }

 private:
  using Ends = std::array<Eigen::Vector3d, 2>;

  [[nodiscard]] int passage(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
  [[nodiscard]] bool meets(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
  int watched_passage(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

  ProjectivePoint centre_, along_;
  ProjectivePoint ahead_, aside_;  // two directions that span the space with the axis
  bool started_ = false;
  Ends ends_;  // of the frame followed last
  int closing_passages_ = 0;
  int turns_ = 0;
  bool met_ = false;
};

}  // namespace ribbon
