// The pairs of features that a collision test looks at: particle-polygon and edge-edge (paper,
// section 5.4.1, Figures 7 and 8).
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "simulation/detection/candidate_pair.h"
#include "simulation/detection/collision_surface.h"

namespace ribbon {

// Two features that share no vertex. vertex_triangle: vertices[0] against triangle vertices[1..3].
// edge_edge: edge vertices[0..1] against edge vertices[2..3].
struct FeaturePair {
  enum class Kind { vertex_triangle, edge_edge };
  Kind kind = Kind::vertex_triangle;
  std::array<int, 4> vertices{};
};

// Where the pair's four vertices are, in its order. positions: 3 x at least all vertices.
inline Eigen::Matrix<double, 3, 4> corners(const FeaturePair& pair,
                                           const Eigen::Matrix3Xd& positions) {
  Eigen::Matrix<double, 3, 4> result;
  for (int k = 0; k < 4; ++k)
    result.col(k) = positions.col(pair.vertices[static_cast<std::size_t>(k)]);
  return result;
}

// One flag for each of so many vertices: is it among the named ones?
std::vector<char> flags_of(std::span<const int> named, std::size_t vertices);
// Has the pair a flagged vertex?
inline bool has_any(const FeaturePair& pair, const std::vector<char>& flags) {
  const auto is_flagged = [&](std::size_t k) {
    return flags[static_cast<std::size_t>(pair.vertices[k])] != 0;
  };
  return is_flagged(0) || is_flagged(1) || is_flagged(2) || is_flagged(3);
}

// A surface and the ranges of the vertices (one for each vertex that any surface uses).
struct RangedSurface {
  const CollisionSurface& surface;
  std::span<const MovingBox> ranges;
};

// The feature pairs of `pairs` (triangles of a and of b, which may be the same surface) whose boxes
// come within margin_m of each other. Each pair of features is listed once.
std::vector<FeaturePair> feature_pairs(const RangedSurface& a, const RangedSurface& b,
                                       std::span<const CandidatePair> pairs, double margin_m);

}  // namespace ribbon
