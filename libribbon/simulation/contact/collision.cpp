#include "simulation/contact/collision.h"

#include <Eigen/Geometry>

#include "geometry/vectors.h"
#include "simulation/detection/closest_weights.h"

namespace ribbon {

namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

using Corners = Eigen::Matrix<double, 3, 4>;  // the four vertices of a pair

// The direction that both kinds of pair are separated along when their contact lies inside both
// features: the triangle's normal, or the common perpendicular of the edges. Not normalised.
Vector3d separating_direction(FeaturePair::Kind kind, const Corners& x) {
  if (kind == FeaturePair::Kind::vertex_triangle)
    return (x.col(2) - x.col(1)).cross(x.col(3) - x.col(1));
  return (x.col(1) - x.col(0)).cross(x.col(3) - x.col(2));
}

// From the second feature to the first.
Vector3d between(FeaturePair::Kind kind, const Corners& x) {
  return kind == FeaturePair::Kind::vertex_triangle ? Vector3d(x.col(0) - x.col(1))
                                                    : Vector3d(x.col(0) - x.col(2));
}

}  // namespace

std::optional<Collision> find_collision(const FeaturePair& pair, const VertexPositions& t0,
                                        const VertexPositions& t1, double activation_m) {
  const Corners x0 = corners(pair, t0);
  const Corners x1 = corners(pair, t1);
  const Vector3d direction0 = separating_direction(pair.kind, x0);
  Vector3d direction1 = separating_direction(pair.kind, x1);
  const double side0 = dot(direction0, between(pair.kind, x0));
  const double side1 = dot(direction1, between(pair.kind, x1));

  if ((side0 > 0 && side1 < 0) || (side0 < 0 && side1 > 0)) {
    const double t = side0 / (side0 - side1);
    const Corners x = (1 - t) * x0 + t * x1;
    const Vector4d weights = closest_weights(pair.kind, x);
    // Coplanar at this instant, they either meet or lie beside each other.
    if (length_of(weighted_sum(x, weights)) <= activation_m) {
      direction1 *= side0 > 0 ? 1 : -1;
      return Collision{weights, normalised(direction1)};
    }
  }

  const Vector4d weights = closest_weights(pair.kind, x1);
  const Vector3d apart = weighted_sum(x1, weights);
  const double distance_m = length_of(apart);
  if (distance_m >= activation_m || distance_m == 0) return std::nullopt;
  return Collision{weights, apart / distance_m};
}

}  // namespace ribbon
