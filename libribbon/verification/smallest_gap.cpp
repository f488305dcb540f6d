#include "verification/smallest_gap.h"

#include <algorithm>
#include <array>
#include <cmath>
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

  void within(const BoxTree& tree, int index) {
    const BoxTree::Node& node = tree.node(index);
    if (node.is_leaf()) {
      const auto triangles = tree.triangles(node);
      for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t j = i + 1; j < triangles.size(); ++j) measure(triangles[i], triangles[j]);
      return;
    }
    for (const int half : node.halves) within(tree, half);
    between(tree, node.halves[0], tree, node.halves[1]);
  }

  void between(const BoxTree& tree, int index, const BoxTree& other_tree, int other_index) {
    const BoxTree::Node& node = tree.node(index);
    const BoxTree::Node& other = other_tree.node(other_index);
    if (is_too_far(node.box, other.box)) return;
    if (node.is_leaf() && other.is_leaf()) {
      for (const int triangle : tree.triangles(node))
        for (const int opponent : other_tree.triangles(other)) measure(triangle, opponent);
      return;
    }
    const bool open_other =
        node.is_leaf() || (!other.is_leaf() && other.end - other.begin > node.end - node.begin);
    if (open_other) {
      for (const int half : nearest_first(node.box, other_tree, other))
        between(tree, index, other_tree, half);
    } else {
      for (const int half : nearest_first(other.box, tree, node))
        between(tree, half, other_tree, other_index);
    }
  }

  [[nodiscard]] const std::optional<SmallestGap>& best() const { return best_; }

 private:
  // The factor covers the rounding of the squared distance and of the limit.
  [[nodiscard]] bool is_too_far(const ClosedBox& a, const ClosedBox& b) const {
    return a.squared_distance(b) > squared_limit_ * (1 + 1e-12);
  }

  static std::array<int, 2> nearest_first(const ClosedBox& box, const BoxTree& tree,
                                          const BoxTree::Node& node) {
    const auto [first, second] = node.halves;
    const bool in_order =
        box.squared_distance(tree.node(first).box) <= box.squared_distance(tree.node(second).box);
    return in_order ? std::array{first, second} : std::array{second, first};
  }

  void measure(int triangle, int other) {
    if (is_too_far(ClosedBox::around(soup_, triangle), ClosedBox::around(soup_, other))) return;
    measure_corners(triangle, other);
    measure_corners(other, triangle);
    for (int k = 0; k < 3; ++k)
      if (owners_.owns_edge(triangle, k)) measure_edge(triangle, k, other);
  }

  // Corners of one triangle against the other.
  void measure_corners(int triangle, int other) {
    const auto opposite = soup_.triangles.col(other);
    for (int k = 0; k < 3; ++k) {
      const int corner = soup_.triangles(k, triangle);
      if (!owners_.owns_corner(triangle, k) || (opposite.array() == corner).any()) continue;
      const Eigen::Vector3f point = soup_.points.col(corner);
      if (is_too_far({point.array(), point.array()}, ClosedBox::around(soup_, other))) continue;
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
          edge[1] == opposite[0] || edge[1] == opposite[1] || is_too_far(box, around(opposite)))
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
  if (!judged.empty()) search.within(judged, BoxTree::root);
  if (!judged.empty() && !rest.empty()) search.between(judged, BoxTree::root, rest, BoxTree::root);
  return search.best();
}

}  // namespace ribbon
