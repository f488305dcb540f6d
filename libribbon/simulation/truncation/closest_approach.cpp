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

// Of a vertex on its way, as seen from the edge pq.
ClosestApproach vertex_to_edge(const Vector3d& vertex, const Vector3d& way, const Vector3d& p,
                               const Vector3d& q) {
  const Vector2d at = closest_on_segments(vertex, vertex + way, p, q);
  return {vertex + at[0] * way - (p + at[1] * (q - p)), at[0]};
}

void take_if_shorter(const ClosestApproach& other, ClosestApproach& shortest) {
  if (squared_length_of(other.apart) < squared_length_of(shortest.apart)) shortest = other;
}

}  // namespace

// Two convex sets that do not meet are closest on the boundary of one of them: at the start, at the
// end, or where the way of a corner lies nearest. Seen from the first feature, the second goes
// backwards.
ClosestApproach closest_approach(FeaturePair::Kind kind, const Corners& start,
                                 const Vector4d& weights, const Corners& displacement) {
  const Vector3d way = weighted_sum(displacement, weights);
  const bool edges = kind == FeaturePair::Kind::edge_edge;
  const int of_first = first_count(kind);
  Corners end = start;
  end.leftCols(of_first).colwise() += way;
  ClosestApproach nearest{weighted_sum(start, weights), 0};
  take_if_shorter({weighted_sum(end, closest_weights(kind, end)), 1}, nearest);
  const auto pass = [&](int vertex, int p, int q) {
    const bool is_of_first = vertex < of_first;
    ClosestApproach passed =
        vertex_to_edge(start.col(vertex), is_of_first ? way : -way, start.col(p), start.col(q));
    if (!is_of_first) passed.apart = -passed.apart;
    take_if_shorter(passed, nearest);
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
  const double squared = squared_length_of(nearest.apart);
  const Vector4d height = heights(start, nearest.apart);
  const double room = height.head(of_first).minCoeff() + std::min(0.0, dot(way, nearest.apart)) -
                      height.tail(4 - of_first).maxCoeff();
  if (room < certain * squared) nearest.apart.setZero();
  return nearest;
}

}  // namespace ribbon
