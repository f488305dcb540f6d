#include "verification/smallest_gap.h"

#include <algorithm>
#include <array>
#include <limits>

#include "verification/feature_distance.h"

namespace ribbon {

namespace {

using Edge = std::array<int, 2>;

// Branch and bound: a pair of nodes whose boxes are further apart than the best gap so far holds no
// better one.
class GapSearch {
 public:
  GapSearch(const TriangleSoup& soup, const FeatureOwners& owners) : soup_(soup), owners_(owners) {}

  // The factor covers the rounding of the squared distance and of the limit.
  [[nodiscard]] bool skips(const ClosedBox& a, const ClosedBox& b) const {
    return a.squared_distance(b) > squared_limit_ * (1 + 1e-12);
  }

  void test(int triangle, int other) {
    if (skips(ClosedBox::around(soup_, triangle), ClosedBox::around(soup_, other))) return;
    measure_corners(triangle, other);
    measure_corners(other, triangle);
    for (int k = 0; k < 3; ++k)
      if (owners_.owns_edge(triangle, k)) measure_edge(triangle, k, other);
  }

  [[nodiscard]] const std::optional<SmallestGap>& best() const { return best_; }

 private:
  // Corners of one triangle against the other.
  void measure_corners(int triangle, int other) {
    const auto opposite = soup_.triangles.col(other);
    for (int k = 0; k < 3; ++k) {
      const int corner = soup_.triangles(k, triangle);
      if (!owners_.owns_corner(triangle, k) || (opposite.array() == corner).any()) continue;
      const Eigen::Vector3f point = soup_.points.col(corner);
      if (skips({point.array(), point.array()}, ClosedBox::around(soup_, other))) continue;
      take(certain_point_triangle_distance(point, soup_.corner(other, 0), soup_.corner(other, 1),
                                           soup_.corner(other, 2), limit()),
           triangle, other);
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
      take(certain_segments_distance(soup_.points.col(edge[0]), soup_.points.col(edge[1]),
                                     soup_.points.col(opposite[0]), soup_.points.col(opposite[1]),
                                     limit()),
           triangle, other);
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

  void take(double distance_m, int triangle, int other) {
    if (distance_m >= limit()) return;
    best_ = {distance_m, {std::min(triangle, other), std::max(triangle, other)}};
    squared_limit_ = distance_m * distance_m;
  }

  [[nodiscard]] double limit() const {
    return best_ ? best_->certain_m : std::numeric_limits<double>::infinity();
  }

  const TriangleSoup& soup_;
  const FeatureOwners& owners_;
  std::optional<SmallestGap> best_;
  double squared_limit_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::optional<SmallestGap> smallest_gap(const TriangleSoup& soup, const FeatureOwners& owners,
                                        const BoxTree& judged, const BoxTree& rest) {
  GapSearch search(soup, owners);
  search_pairs(judged, rest, search);
  return search.best();
}

}  // namespace ribbon
