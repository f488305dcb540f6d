// The pairs of features that a collision test looks at: particle-polygon and edge-edge (paper,
// section 5.4.1, Figures 7 and 8).
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "simulation/detection/candidate_pair.h"
#include "simulation/detection/collision_surface.h"
#include "simulation/detection/vertex_positions.h"

namespace ribbon {

// Two features that share no vertex. vertex_triangle: vertices[0] against triangle vertices[1..3].
// edge_edge: edge vertices[0..1] against edge vertices[2..3]. Particles of the ribbon are numbered
// from 0 on, vertices of the obstacle after them.
struct FeaturePair {
  enum class Kind { vertex_triangle, edge_edge };
  Kind kind = Kind::vertex_triangle;
  std::array<int, 4> vertices{};
};

// How many of a pair's vertices its first feature has.
constexpr int first_count(FeaturePair::Kind kind) {
  return kind == FeaturePair::Kind::vertex_triangle ? 1 : 2;
}

// Where the pair's four vertices are, in its order.
inline Eigen::Matrix<double, 3, 4> corners(const FeaturePair& pair,
                                           const VertexPositions& positions) {
  Eigen::Matrix<double, 3, 4> result;
  for (int k = 0; k < 4; ++k) result.col(k) = positions[pair.vertices[k]];
  return result;
}

// How far they move, given how far particles do (3 x particles): the obstacle's vertices stay.
inline Eigen::Matrix<double, 3, 4> displacements(const FeaturePair& pair,
                                                 const Eigen::Matrix3Xd& of_particles) {
  Eigen::Matrix<double, 3, 4> result;
  for (int k = 0; k < 4; ++k)
    if (pair.vertices[k] < of_particles.cols())
      result.col(k) = of_particles.col(pair.vertices[k]);
    else
      result.col(k).setZero();
  return result;
}

// Has the pair a flagged particle? One flag for each.
inline bool has_any(const FeaturePair& pair, const std::vector<char>& flags) {
  return std::any_of(pair.vertices.begin(), pair.vertices.end(), [&](int vertex) {
    return vertex < static_cast<int>(flags.size()) && flags[vertex] != 0;
  });
}

// A surface with the ranges of its vertices, the first of which features give this number.
struct RangedSurface {
  const CollisionSurface& surface;
  std::span<const MovingBox> ranges;
  int first_vertex = 0;
};

// The feature pairs of `pairs` (triangles of a and of b, which may be the same surface) whose boxes
// come within margin_m of each other. Each pair of features is listed once.
std::vector<FeaturePair> feature_pairs(const RangedSurface& a, const RangedSurface& b,
                                       std::span<const CandidatePair> pairs, double margin_m);

}  // namespace ribbon
