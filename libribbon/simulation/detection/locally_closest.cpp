#include "simulation/detection/locally_closest.h"

#include <array>

#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

// Sine of the angle by which a neighbour must lie toward the other feature: rounding, and what is
// nearly flat, count as flat.
constexpr double toward = 0.01;

// The point of a triangle and the corners that have a share in it.
struct TrianglePoint {
  TrianglePoint(const FeaturePair& pair, const Vector4d& weights,
                const VertexPositions& positions) {
    for (int k = 1; k < 4; ++k) {
      if (weights[k] == 0) continue;
      const int vertex = pair.vertices[k];
      place -= weights[k] * positions[vertex];
      corners[corner_count++] = vertex;
    }
  }

  Vector3d place = Vector3d::Zero();
  std::array<int, 3> corners{};
  int corner_count = 0;
};

bool lies_toward(const Vector3d& neighbour, const TrianglePoint& point, const Vector3d& direction) {
  const Vector3d way = neighbour - point.place;
  return dot(way, direction) > toward * length_of(way);
}

// Does a neighbour of the point lie in that direction? Inside a triangle it has none; inside an
// edge, the corners beside it are.
bool has_neighbour_toward(const Vector3d& direction, const TrianglePoint& point,
                          const VertexPositions& positions, const Bodies& bodies) {
  const auto is_toward = [&](int vertex) {
    return lies_toward(positions[vertex], point, direction);
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
  if (pair.kind == FeaturePair::Kind::edge_edge) return (weights.array() != 0).all();
  return !has_neighbour_toward(direction, {pair, weights, positions}, positions, bodies);
}

}  // namespace ribbon
