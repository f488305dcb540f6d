// Which side is a point on? Exact answers for points in space and at infinity.
#pragma once

#include <Eigen/Core>

namespace ribbon {

// A point, or the point at infinity at which rays in the direction `at` arrive. Coordinates are
// finite.
struct Place {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  bool is_direction = false;

  static Place point(const Eigen::Vector3d& at) { return {at, false}; }
  static Place direction(const Eigen::Vector3d& at) { return {at, true}; }
};

// The sign (-1, 0 or 1) of det(b - a, c - a, d - a): positive where a, b, c turn counter-clockwise
// seen from d. For a direction, the sign that far points along it have in the end; with d = the
// direction towards the viewer it is the turn a, b, c as the viewer sees it. Exact whatever the
// coordinates, so that no verdict is a matter of rounding. 0 if all four are directions.
int orientation(const Place& a, const Place& b, const Place& c, const Place& d);

// Going from p to q, seen from `view`: is line rs met before line uw (-1), at the same place (0) or
// after it (1)? Exact. Both lines separate p from q.
int order_along(const Place& p, const Place& q, const Place& r, const Place& s, const Place& u,
                const Place& w, const Place& view);

}  // namespace ribbon
