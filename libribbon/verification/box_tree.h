// A tree of boxes over triangles, made to be obviously right: built anew for every frame, boxes
// closed, nothing left out.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "verification/triangle_soup.h"

namespace ribbon {

// Both ends belong to it. Its coordinates are recorded ones, so nothing is rounded.
struct ClosedBox {
  Eigen::Array3f low;
  Eigen::Array3f high;

  static ClosedBox around(const TriangleSoup& soup, int triangle);
  void include(const ClosedBox& box) {
    low = low.min(box.low);
    high = high.max(box.high);
  }
  [[nodiscard]] bool meets(const ClosedBox& box) const {
    return (low <= box.high).all() && (box.low <= high).all();
  }
  // 0 where they meet; rounded, to a relative error of at most 2^-50.
  [[nodiscard]] double squared_distance(const ClosedBox& box) const;
};

class BoxTree {
 public:
  struct Node {
    ClosedBox box;
    int begin = 0;  // its triangles, as a range of triangles_
    int end = 0;
    // Indices of its two halves; none of a leaf.
    std::array<int, 2> halves = {-1, -1};

    [[nodiscard]] bool is_leaf() const { return halves[0] < 0; }
  };

  // Of triangles first to last - 1 of the soup, all at finite positions; there may be none.
  BoxTree(const TriangleSoup& soup, int first, int last);

  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] const Node& node(int index) const { return nodes_[index]; }
  [[nodiscard]] const Node& root() const { return nodes_.front(); }  // of a tree that is not empty
  // The triangles of a node.
  [[nodiscard]] std::span<const int> triangles(const Node& node) const {
    return std::span(triangles_).subspan(node.begin, node.end - node.begin);
  }
  // The halves of a node that is no leaf.
  [[nodiscard]] std::array<int, 2> nearest_half_first(const Node& node,
                                                      const ClosedBox& box) const {
    const auto [first, second] = node.halves;
    const bool in_order =
        box.squared_distance(nodes_[first].box) <= box.squared_distance(nodes_[second].box);
    return in_order ? std::array{first, second} : std::array{second, first};
  }

 private:
  int build(const std::vector<ClosedBox>& boxes, int first, int begin, int end);

  std::vector<Node> nodes_;
  std::vector<int> triangles_;
};

// Walks through all pairs of leaves of one tree, and through those of two trees, but for pairs
// below nodes that search.skips(box, other_box), and hands every pair of triangles that remain to
// search.test(triangle, other). Near pairs come early.
template <class Search>
void search_between(const BoxTree& tree, const BoxTree::Node& node, const BoxTree& other_tree,
                    const BoxTree::Node& other, Search& search) {
  if (search.skips(node.box, other.box)) return;
  if (node.is_leaf() && other.is_leaf()) {
    for (const int triangle : tree.triangles(node))
      for (const int opponent : other_tree.triangles(other)) search.test(triangle, opponent);
    return;
  }
  const bool opens_other =
      node.is_leaf() || (!other.is_leaf() && other.end - other.begin > node.end - node.begin);
  if (opens_other) {
    for (const int half : other_tree.nearest_half_first(other, node.box))
      search_between(tree, node, other_tree, other_tree.node(half), search);
  } else {
    for (const int half : tree.nearest_half_first(node, other.box))
      search_between(tree, tree.node(half), other_tree, other, search);
  }
}

template <class Search>
void search_within(const BoxTree& tree, const BoxTree::Node& node, Search& search) {
  if (node.is_leaf()) {
    const auto triangles = tree.triangles(node);
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (std::size_t j = i + 1; j < triangles.size(); ++j)
        search.test(triangles[i], triangles[j]);
    return;
  }
  for (const int half : node.halves) search_within(tree, tree.node(half), search);
  search_between(tree, tree.node(node.halves[0]), tree, tree.node(node.halves[1]), search);
}

// The pairs of a judged triangle and any other.
template <class Search>
void search_pairs(const BoxTree& judged, const BoxTree& rest, Search& search) {
  if (judged.empty()) return;
  search_within(judged, judged.root(), search);
  if (!rest.empty()) search_between(judged, judged.root(), rest, rest.root(), search);
}

}  // namespace ribbon
