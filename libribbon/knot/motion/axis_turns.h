// How often does the ribbon go round an object?
#pragma once

#include <Eigen/Core>

#include "exact/orientation.h"
#include "geometry/object_axis.h"

namespace ribbon {

// Counts the turns of a curve about an object's axis. The curve is closed by the trails of its two
// ends, back to the first frame, and by the straight line between them there. So the number stays
// when the ends travel round the axis, and changes only when the curve passes through it: within
// the object, which takes passing through the object, or over one of its ends, which does not. What
// passes over an end is counted by itself. All tests are exact, but for where on the axis something
// passed.
class AxisTurns {
 public:
  explicit AxisTurns(ObjectAxis axis);

  // The next frame's curve, 3 x the same at least 2. Between two frames, all points move straight.
  void follow(const Eigen::Matrix3Xd& curve);

  // Counter-clockwise looking against the direction of the axis; those of the first frame but for
  // what has passed through the object.
  [[nodiscard]] int turns() const { return turns_ - over_ends_; }
  // By how many turns what has passed over the object's ends has changed the number.
  [[nodiscard]] int turns_over_ends() const { return over_ends_; }
  // Has the curve, or the trail of an end, touched the axis within the object in some frame?
  [[nodiscard]] bool met() const { return met_; }

 private:
  [[nodiscard]] int passage(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
  [[nodiscard]] bool meets(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
  int watched_passage(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
  int turns_of(const Eigen::Matrix3Xd& curve);
  [[nodiscard]] int swept_over_ends(const Eigen::Matrix3Xd& before,
                                    const Eigen::Matrix3Xd& now) const;
  [[nodiscard]] int swept_over_ends(const Eigen::Matrix3d& triangle, double move_m) const;

  ObjectAxis axis_;
  ProjectivePoint centre_, along_;
  ProjectivePoint ahead_, aside_;  // two directions that span the space with the axis
  Eigen::Matrix3Xd curve_;         // of the frame followed last; empty before the first
  int closing_passages_ = 0;
  int turns_ = 0;
  int over_ends_ = 0;
  bool met_ = false;
};

}  // namespace ribbon
