#include "simulation/detection/closest_weights.h"

#include "geometry/closest_points.h"

namespace ribbon {

Eigen::Vector4d closest_weights(FeaturePair::Kind kind,
                                const Eigen::Matrix<double, 3, 4>& corners) {
  if (kind == FeaturePair::Kind::vertex_triangle) {
    const Eigen::Vector3d on_triangle =
        closest_on_triangle(corners.col(0), corners.col(1), corners.col(2), corners.col(3));
    return {1, -on_triangle[0], -on_triangle[1], -on_triangle[2]};
  }
  const Eigen::Vector2d on_edges =
      closest_on_segments(corners.col(0), corners.col(1), corners.col(2), corners.col(3));
  return {1 - on_edges[0], on_edges[0], on_edges[1] - 1, -on_edges[1]};
}

}  // namespace ribbon
