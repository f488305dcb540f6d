// Measures the pairs of features that share no vertex.
#pragma once

#include <array>

#include "verification/box_tree.h"
#include "verification/feature_distance.h"
#include "verification/feature_owners.h"
#include "verification/triangle_soup.h"

namespace ribbon {

// A vertex and a triangle, or two edges: their four vertices, and triangles that have them.
struct MeasuredPair {
  std::array<int, 4> vertices;
  int triangle;
  int other;
};

// To be handed to search_pairs(). Every pair whose distance may be below measure.limit(), which may
// shrink on the way, is handed to measure.take(certain distance, pair).
template <class Measure>
class FeaturePairSearch {
 public:
  FeaturePairSearch(const TriangleSoup& soup, const FeatureOwners& owners, Measure& measure)
      : soup_(soup), owners_(owners), measure_(measure) {}

  // The factor covers the rounding of the squared distance and of the limit.
  [[nodiscard]] bool skips(const ClosedBox& a, const ClosedBox& b) const {
    const double limit = measure_.limit();
    return a.squared_distance(b) > limit * limit * (1 + 1e-12);
  }

  void test(int triangle, int other) {
    if (skips(ClosedBox::around(soup_, triangle), ClosedBox::around(soup_, other))) return;
    measure_corners(triangle, other);
    measure_corners(other, triangle);
    for (int k = 0; k < 3; ++k)
      if (owners_.owns_edge(triangle, k)) measure_edge(triangle, k, other);
  }

 private:
  using Edge = std::array<int, 2>;

  // Corners of one triangle against the other.
  void measure_corners(int triangle, int other) {
    const auto opposite = soup_.triangles.col(other);
    for (int k = 0; k < 3; ++k) {
      const int corner = soup_.triangles(k, triangle);
      if (!owners_.owns_corner(triangle, k) || (opposite.array() == corner).any()) continue;
      const Eigen::Vector3f point = soup_.points.col(corner);
      if (skips({point.array(), point.array()}, ClosedBox::around(soup_, other))) continue;
      measure_.take(
          certain_point_triangle_distance(point, soup_.corner(other, 0), soup_.corner(other, 1),
                                          soup_.corner(other, 2), measure_.limit()),
          {{corner, opposite[0], opposite[1], opposite[2]}, triangle, other});
    }
  }

  // Edge k of one triangle against the edges of the other.
  void measure_edge(int triangle, int k, int other) {
    const Edge edge = edge_of(triangle, k);
    const ClosedBox box = around(edge);
    for (int l = 0; l < 3; ++l) {
      const Edge opposite = edge_of(other, l);
      if (!owners_.owns_edge(other, l) || edge[0] == opposite[0] || edge[0] == opposite[1] ||
          edge[1] == opposite[0] || edge[1] == opposite[1] || skips(box, around(opposite)))
        continue;
      measure_.take(certain_segments_distance(soup_.points.col(edge[0]), soup_.points.col(edge[1]),
                                              soup_.points.col(opposite[0]),
                                              soup_.points.col(opposite[1]), measure_.limit()),
                    {{edge[0], edge[1], opposite[0], opposite[1]}, triangle, other});
    }
  }

  [[nodiscard]] Edge edge_of(int triangle, int k) const {
    return {soup_.triangles(k, triangle), soup_.triangles((k + 1) % 3, triangle)};
  }

  [[nodiscard]] ClosedBox around(const Edge& edge) const {
    const Eigen::Array3f a = soup_.points.col(edge[0]);
    const Eigen::Array3f b = soup_.points.col(edge[1]);
    return {a.min(b), a.max(b)};
  }

  const TriangleSoup& soup_;
  const FeatureOwners& owners_;
  Measure& measure_;
};

}  // namespace ribbon
