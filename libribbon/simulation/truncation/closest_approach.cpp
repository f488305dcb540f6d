#include "simulation/truncation/closest_approach.h"

#include <algorithm>

#include "geometry/closest_points.h"
#include "geometry/vectors.h"
#include "simulation/detection/closest_weights.h"

namespace ribbon {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Corners = Eigen::Matrix<double, 3, 4>;

// Of a distance: room that no rounding feigns.
constexpr double certain = 0.5;

// From the way of a vertex to the edge pq.
Vector3d from_way_to_edge(const Vector3d& vertex, const Vector3d& way, const Vector3d& p,
                          const Vector3d& q) {
  const Vector2d at = closest_on_segments(vertex, vertex + way, p, q);
  return p + at[1] * (q - p) - (vertex + at[0] * way);
}

void take_if_shorter(const Vector3d& other, Vector3d& shortest) {
  if (squared_length_of(other) < squared_length_of(shortest)) shortest = other;
}

}  // namespace

// Two convex sets that do not meet are closest on the boundary of one of them: at the start, at the
// end, or where the way of a corner lies nearest. Seen from the first feature, the second goes
// backwards.
Vector3d closest_approach(FeaturePair::Kind kind, const Corners& start, const Vector4d& weights,
                          const Corners& displacement) {
  const Vector3d way = weighted_sum(displacement, weights);
  const bool edges = kind == FeaturePair::Kind::edge_edge;
  const int first_count = edges ? 2 : 1;
  Corners end = start;
  end.leftCols(first_count).colwise() += way;
  Vector3d nearest = weighted_sum(start, weights);
  take_if_shorter(weighted_sum(end, closest_weights(kind, end)), nearest);
  const auto pass = [&](int vertex, int p, int q) {
    const bool is_of_first = vertex < first_count;
    const Vector3d apart =
        from_way_to_edge(start.col(vertex), is_of_first ? way : -way, start.col(p), start.col(q));
    take_if_shorter(is_of_first ? -apart : apart, nearest);
  };
  if (edges) {
    pass(0, 2, 3);
    pass(1, 2, 3);
    pass(2, 0, 1);
    pass(3, 0, 1);
  } else {
    pass(0, 1, 2);
    pass(0, 2, 3);
    pass(0, 3, 1);
  }
  const double squared = squared_length_of(nearest);
  const Vector4d height = heights(start, nearest);
  const double room = height.head(first_count).minCoeff() + std::min(0.0, dot(way, nearest)) -
                      height.tail(4 - first_count).maxCoeff();
  if (room < certain * squared) nearest.setZero();
  return nearest;
}

}  // namespace ribbon
