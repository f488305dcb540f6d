// On which side? Signs of determinants that no rounding can change: the exact predicates of
// verification and knot theory.
#pragma once

#include <Eigen/Core>

namespace ribbon {

// A point, or the point at infinity at which rays in the direction `at` arrive. Coordinates are
// finite.
struct ProjectivePoint {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  bool is_direction = false;

  static ProjectivePoint point(const Eigen::Vector3d& at) { return {at, false}; }
  static ProjectivePoint direction(const Eigen::Vector3d& at) { return {at, true}; }
};

// All signs are exact for all finite coordinates, the tiniest and the largest included: computed in
// double precision with a bound of its rounding, and in integers where that does not settle them.

// The sign (-1, 0 or 1) of det(b - a, c - a, d - a): positive where a, b, c turn counter-clockwise
// seen from d. For a direction, the sign that far points along it have in the end; with d = the
// direction towards the viewer it is the turn a, b, c as the viewer sees it. 0 if all four are
// directions.
int orientation(const ProjectivePoint& a, const ProjectivePoint& b, const ProjectivePoint& c,
                const ProjectivePoint& d);

// The same of recorded points, several times faster: 1 where a, b, c turn counter-clockwise seen
// from d's side of their plane, 0 where all four lie in one plane.
int side_of_plane(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c,
                  const Eigen::Vector3f& d);

// And in the plane: 1 where a, b, c turn counter-clockwise, 0 where they lie on one line.
int turn(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Eigen::Vector2f& c);

// Going from p to q, seen from `view`: is line rs met before line uw (-1), at the same point (0) or
// after it (1)? Both lines separate p from q.
int order_along(const ProjectivePoint& p, const ProjectivePoint& q, const ProjectivePoint& r,
                const ProjectivePoint& s, const ProjectivePoint& u, const ProjectivePoint& w,
                const ProjectivePoint& view);

}  // namespace ribbon
