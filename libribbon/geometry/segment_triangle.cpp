#include "geometry/segment_triangle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::Vector3d;

// Six times the signed volume of tetrahedron abcd: positive when d lies on the side of triangle abc
// from which it is seen counter-clockwise.
double volume(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  return dot((b - a).cross(c - a), d - a);
}

// The volumes over triangle abc that the rounding of coordinates alone can bring about.
double rounding(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double largest =
      std::max({a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff()});
  return 32 * std::numeric_limits<double>::epsilon() * largest * length_of(b - a) *
         length_of(c - a);
}

}  // namespace

std::optional<Piercing> pierce(const Vector3d& p, const Vector3d& q, const Vector3d& a,
                               const Vector3d& b, const Vector3d& c) {
  const double p_side = volume(a, b, c, p);
  const double q_side = volume(a, b, c, q);
  if ((p_side > 0) == (q_side > 0) || p_side == q_side) return std::nullopt;
  if (std::max(std::abs(p_side), std::abs(q_side)) <= rounding(a, b, c)) return std::nullopt;
  // The line pq passes the triangle's three edges on the same side exactly when it goes through.
  Vector3d weights(volume(p, q, b, c), volume(p, q, c, a), volume(p, q, a, b));
  if ((weights.array() < 0).any() && (weights.array() > 0).any()) return std::nullopt;
  const double sum = weights[0] + weights[1] + weights[2];
  if (sum == 0) return std::nullopt;
  return Piercing{weights / sum};
}

}  // namespace ribbon
