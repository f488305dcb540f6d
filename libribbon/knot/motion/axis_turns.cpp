#include "knot/motion/axis_turns.h"

#include <Eigen/Geometry>
#include <cassert>

namespace ribbon {

AxisTurns::AxisTurns(const CentreAxis& axis)
    : centre_(ProjectivePoint::point(axis.point_m)),
      along_(ProjectivePoint::direction(axis.direction)) {
  Eigen::Index thinnest = 0;
  axis.direction.cwiseAbs().minCoeff(&thinnest);
  const Eigen::Vector3d ahead = axis.direction.cross(Eigen::Vector3d::Unit(thinnest));
  ahead_ = ProjectivePoint::direction(ahead);
  aside_ = ProjectivePoint::direction(axis.direction.cross(ahead));
}

// Through the half plane that the axis bounds in the direction ahead_, counter-clockwise. A point
// in the plane counts as lying on its left.
int AxisTurns::passage(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  const bool from_left = orientation(centre_, along_, ahead_, ProjectivePoint::point(from)) >= 0;
  const bool to_left = orientation(centre_, along_, ahead_, ProjectivePoint::point(to)) >= 0;
  if (from_left == to_left) return 0;
  const int sense =
      orientation(ProjectivePoint::point(from), ProjectivePoint::point(to), centre_, along_);
  if (to_left) return sense > 0 ? 1 : 0;
  return sense < 0 ? -1 : 0;
}

bool AxisTurns::meets(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  const auto on_one_side = [&](const ProjectivePoint& direction) {
    return orientation(centre_, along_, direction, ProjectivePoint::point(from)) *
               orientation(centre_, along_, direction, ProjectivePoint::point(to)) >
           0;
  };
  return orientation(ProjectivePoint::point(from), ProjectivePoint::point(to), centre_, along_) ==
             0 &&
         !on_one_side(ahead_) && !on_one_side(aside_);
}

int AxisTurns::watched_passage(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  met_ = met_ || meets(from, to);
  return passage(from, to);
}

void AxisTurns::follow(const Eigen::Matrix3Xd& curve) {
  assert(curve.cols() >= 2);
  const Ends ends{curve.col(0), curve.col(curve.cols() - 1)};
  if (!started_) {
    closing_passages_ = passage(ends[1], ends[0]);
    started_ = true;
  } else {
    closing_passages_ += watched_passage(ends_[0], ends[0]) + watched_passage(ends[1], ends_[1]);
  }
  ends_ = ends;
  turns_ = closing_passages_;
  for (Eigen::Index k = 0; k + 1 < curve.cols(); ++k)
    turns_ += watched_passage(curve.col(k), curve.col(k + 1));
}

}  // namespace ribbon
