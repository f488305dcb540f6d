#include "knot/motion/axis_turns.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "geometry/vectors.h"

namespace ribbon {

namespace {

// What passes so near to the object's end may have passed over it: of the way that it moved from
// one frame to the next. Frames do not show how it moved, and a strand that slips over a round end
// seems to cut through it.
constexpr double doubtful_fraction = 0.25;

// The height at which the plane of a triangle that is pierced by the axis meets it.
double height_of_passage_m(const ObjectAxis& axis, const Eigen::Matrix3d& triangle) {
  const auto height = [&](const Eigen::Vector3d& point) {
    return dot(axis.line.direction, point - axis.line.point_m);
  };
  const Eigen::Vector3d heights(height(triangle.col(0)), height(triangle.col(1)),
                                height(triangle.col(2)));
  const Eigen::Vector3d normal =
      (triangle.col(1) - triangle.col(0)).cross(triangle.col(2) - triangle.col(0));
  const double height_m =
      dot(normal, triangle.col(0) - axis.line.point_m) / dot(normal, axis.line.direction);
  if (std::isnan(height_m)) return (heights.x() + heights.y() + heights.z()) / 3;
  return std::clamp(height_m, heights.minCoeff(), heights.maxCoeff());
}

}  // namespace

AxisTurns::AxisTurns(ObjectAxis axis)
    : axis_(std::move(axis)),
      centre_(ProjectivePoint::point(axis_.line.point_m)),
      along_(ProjectivePoint::direction(axis_.line.direction)) {
  Eigen::Index thinnest = 0;
  along_.at.cwiseAbs().minCoeff(&thinnest);
  ahead_ = ProjectivePoint::direction(along_.at.cross(Eigen::Vector3d::Unit(thinnest)));
  aside_ = ProjectivePoint::direction(along_.at.cross(ahead_.at));
}

// Through the half plane that the axis bounds in the direction ahead_, counter-clockwise. A point
// in the plane counts as lying on its left.
int AxisTurns::passage(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  const auto start = ProjectivePoint::point(from);
  const auto end = ProjectivePoint::point(to);
  const bool from_left = orientation(centre_, along_, ahead_, start) >= 0;
  const bool to_left = orientation(centre_, along_, ahead_, end) >= 0;
  if (from_left == to_left) return 0;
  const int sense = orientation(start, end, centre_, along_);
  if (to_left) return sense > 0 ? 1 : 0;
  return sense < 0 ? -1 : 0;
}

bool AxisTurns::meets(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  const auto start = ProjectivePoint::point(from);
  const auto end = ProjectivePoint::point(to);
  const auto on_one_side = [&](const ProjectivePoint& direction) {
    return orientation(centre_, along_, direction, start) *
               orientation(centre_, along_, direction, end) >
           0;
  };
  return orientation(start, end, centre_, along_) == 0 && !on_one_side(ahead_) &&
         !on_one_side(aside_);
}

int AxisTurns::watched_passage(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  if (!met_ && meets(from, to)) met_ = axis_.is_inside(axis_.height_m((from + to) / 2));
  return passage(from, to);
}

int AxisTurns::turns_of(const Eigen::Matrix3Xd& curve) {
  const Eigen::Index last = curve.cols() - 1;
  if (curve_.cols() == 0)
    closing_passages_ = passage(curve.col(last), curve.col(0));
  else
    closing_passages_ += watched_passage(curve_.col(0), curve.col(0)) +
                         watched_passage(curve.col(last), curve_.col(last));
  int turns = closing_passages_;
  for (Eigen::Index k = 0; k < last; ++k) turns += watched_passage(curve.col(k), curve.col(k + 1));
  return turns;
}

// Of a triangle that is swept: the turns of its border, if it does not surely pass the axis within
// the object.
int AxisTurns::swept_over_ends(const Eigen::Matrix3d& triangle, double move_m) const {
  int turns = 0;
  for (int k = 0; k < 3; ++k) turns += passage(triangle.col(k), triangle.col((k + 1) % 3));
  if (turns == 0) return 0;
  const double height_m = height_of_passage_m(axis_, triangle);
  const double doubt_m = doubtful_fraction * move_m;
  const bool surely_inside = axis_.is_inside(height_m - doubt_m) && axis_.is_inside(height_m) &&
                             axis_.is_inside(height_m + doubt_m);
  return surely_inside ? 0 : turns;
}

// Each edge of the curve sweeps two triangles; their borders add up to the curve now, the trails of
// its ends and the curve before, backwards.
int AxisTurns::swept_over_ends(const Eigen::Matrix3Xd& before, const Eigen::Matrix3Xd& now) const {
  int turns = 0;
  for (Eigen::Index k = 0; k + 1 < now.cols(); ++k) {
    const double move_m = std::max(length_of(now.col(k) - before.col(k)),
                                   length_of(now.col(k + 1) - before.col(k + 1)));
    Eigen::Matrix3d first;
    Eigen::Matrix3d second;
    first << before.col(k), now.col(k), now.col(k + 1);
    second << before.col(k), now.col(k + 1), before.col(k + 1);
    turns += swept_over_ends(first, move_m) + swept_over_ends(second, move_m);
  }
  return turns;
}

void AxisTurns::follow(const Eigen::Matrix3Xd& curve) {
  assert(curve.cols() >= 2);
  const int turns = turns_of(curve);
  // Where a turn came from is looked for only when there is one.
  if (curve_.cols() > 0 && turns != turns_) over_ends_ += swept_over_ends(curve_, curve);
  turns_ = turns;
  curve_ = curve;
}

}  // namespace ribbon
