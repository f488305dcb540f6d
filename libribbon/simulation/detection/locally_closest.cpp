#include "simulation/detection/locally_closest.h"

#include <array>
#include <cmath>

#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

// Sines of the angles by which a neighbour must lie toward the other feature: rounding, and what is
// nearly flat, count as flat.
constexpr double from_triangle = 0.01;
constexpr double from_obstacle = 0.03;  // its edges and vertices
constexpr double doubtful = 1e-9;       // of a corner's distance: how far it lies beside an edge

// The closest point of a feature and the corners that have a share in it.
struct FeaturePoint {
  // Of the pair's vertices from `begin` to `end`.
  FeaturePoint(const FeaturePair& pair, int begin, int end, const Vector4d& weights,
               const VertexPositions& positions) {
    for (int k = begin; k < end; ++k) {
      if (weights[k] == 0) continue;
      const int vertex = pair.vertices[k];
      place += std::abs(weights[k]) * positions[vertex];
      corners[corner_count++] = vertex;
    }
  }

  Vector3d place = Vector3d::Zero();
  std::array<int, 3> corners{};
  int corner_count = 0;
};

// Does a neighbour of the point lie in that direction, by more than this sine? Inside a triangle it
// has none. Inside an edge it has the triangles there, which lie straight beside the point, however
// far along the edge their corners are.
bool has_neighbour_toward(const Vector3d& direction, double sine, const FeaturePoint& point,
                          const VertexPositions& positions, const Bodies& bodies) {
  Vector3d along = Vector3d::Zero();
  if (point.corner_count == 2)
    along = safely_normalised((positions[point.corners[1]] - positions[point.corners[0]]).eval());
  const auto is_toward = [&](int vertex) {
    const Vector3d way = positions[vertex] - point.place;
    const Vector3d beside = way - dot(way, along) * along;
    const double beside_m = length_of(beside);
    // Corners of a triangle without area lie on its edge, but for rounding.
    return beside_m > doubtful * length_of(way) && dot(beside, direction) > sine * beside_m;
  };
  if (point.corner_count == 1)
    return bodies.any_triangle_at(point.corners[0],
                                  [&](int b, int c) { return is_toward(b) || is_toward(c); });
  if (point.corner_count == 3) return false;
  const auto [corner, end] = bodies.smaller_fan_first(point.corners[0], point.corners[1]);
  return bodies.any_triangle_at(corner, [&, end = end](int b, int c) {
    return (c == end && is_toward(b)) || (b == end && is_toward(c));
  });
}

}  // namespace

bool are_locally_closest(const FeaturePair& pair, const Vector4d& weights,
                         const Vector3d& direction, const VertexPositions& positions,
                         const Bodies& bodies) {
  if (pair.kind == FeaturePair::Kind::edge_edge && (weights.array() == 0).any()) return false;
  const auto is_closest = [&](int begin, int end, const Vector3d& to_other) {
    const bool of_triangle = end - begin == 3;
    if (!of_triangle && bodies.is_particle(pair.vertices[begin])) return true;
    return !has_neighbour_toward(to_other, of_triangle ? from_triangle : from_obstacle,
                                 {pair, begin, end, weights, positions}, positions, bodies);
  };
  const int of_first = first_count(pair.kind);
  return is_closest(of_first, 4, direction) && is_closest(0, of_first, -direction);
}

}  // namespace ribbon
