#include "simulation/detection/collision_surface.h"

#include <algorithm>
#include <utility>

namespace ribbon {

namespace {

// Sides of triangles are numbered three times the triangle plus the corner where they start.
std::array<int, 2> ends_of(const Eigen::Matrix3Xi& triangles, int side) {
  const int a = triangles(side % 3, side / 3);
  const int b = triangles((side + 1) % 3, side / 3);
  return {std::min(a, b), std::max(a, b)};
}

// For each key the place of the first one that is equal.
template <class Key>
std::vector<int> first_of_equals(const std::vector<Key>& keys) {
  std::vector<std::pair<Key, int>> sorted(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) sorted[i] = {keys[i], static_cast<int>(i)};
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> first(keys.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const auto& [key, place] = sorted[i];
    const bool is_new = i == 0 || key != sorted[i - 1].first;
    first[place] = is_new ? place : first[sorted[i - 1].second];
  }
  return first;
}

// For each side the first one that is the same edge.
std::vector<int> first_sides(const Eigen::Matrix3Xi& triangles) {
  std::vector<std::array<int, 2>> sides(triangles.size());
  for (std::size_t i = 0; i < sides.size(); ++i) sides[i] = ends_of(triangles, static_cast<int>(i));
  return first_of_equals(sides);
}

void number_edges(CollisionSurface& surface) {
  const std::vector<int> first = first_sides(surface.triangles);
  std::size_t edges = 0;
  for (std::size_t side = 0; side < first.size(); ++side)
    edges += first[side] == static_cast<int>(side) ? 1 : 0;
  surface.edges.reserve(edges);
  for (std::size_t side = 0; side < first.size(); ++side) {
    const auto original = static_cast<std::size_t>(first[side]);
    int& edge = surface.triangle_edges[side / 3][side % 3];
    edge = surface.triangle_edges[original / 3][original % 3];
    if (original != side) continue;
    edge = static_cast<int>(surface.edges.size());
    surface.edges.push_back(ends_of(surface.triangles, static_cast<int>(side)));
    surface.answers_for[side / 3] |= static_cast<std::uint8_t>(8U << (side % 3));
  }
}

void share_out_vertices(CollisionSurface& surface) {
  std::vector<bool> seen(surface.triangles.maxCoeff() + 1);
  unsigned side = 0;
  for (const int vertex : surface.triangles.reshaped()) {
    if (!seen[vertex]) surface.answers_for[side / 3] |= static_cast<std::uint8_t>(1U << (side % 3));
    seen[vertex] = true;
    ++side;
  }
}

}  // namespace

CollisionSurface collision_surface(Eigen::Matrix3Xi triangles) {
  CollisionSurface surface;
  surface.triangles = std::move(triangles);
  if (surface.triangles.cols() == 0) return surface;
  surface.triangle_edges.resize(surface.triangles.cols());
  surface.answers_for.resize(surface.triangles.cols());
  number_edges(surface);
  share_out_vertices(surface);
  return surface;
}

Eigen::Matrix3Xi with_equal_vertices_joined(Eigen::Matrix3Xi triangles,
                                            const Eigen::Matrix3Xd& vertices) {
  std::vector<std::array<double, 3>> places;
  for (const auto& vertex : vertices.colwise()) places.push_back({vertex[0], vertex[1], vertex[2]});
  const std::vector<int> first = first_of_equals(places);
  for (auto triangle : triangles.colwise()) {
    const Eigen::Vector3i corners(first[triangle[0]], first[triangle[1]], first[triangle[2]]);
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
      triangle = corners;
  }
  return triangles;
}

}  // namespace ribbon
