#include "verification/intersecting_pairs.h"

#include <algorithm>
#include <utility>

#include "verification/triangles_meet.h"

namespace ribbon {

namespace {

class PairSearch {
 public:
  PairSearch(const TriangleSoup& soup, std::size_t most) : soup_(soup), most_(most) {}

  // All pairs within one tree.
  void within(const BoxTree& tree, int index) {
    const BoxTree::Node& node = tree.node(index);
    if (node.is_leaf()) {
      const auto triangles = tree.triangles(node);
      for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t j = i + 1; j < triangles.size(); ++j) test(triangles[i], triangles[j]);
      return;
    }
    for (const int half : node.halves) within(tree, half);
    between(tree, node.halves[0], tree, node.halves[1]);
  }

  // All pairs of a triangle below one node and one below another that does not contain it.
  void between(const BoxTree& tree, int index, const BoxTree& other_tree, int other_index) {
    const BoxTree::Node& node = tree.node(index);
    const BoxTree::Node& other = other_tree.node(other_index);
    if (!node.box.meets(other.box) || is_full()) return;
    if (node.is_leaf() && other.is_leaf()) {
      for (const int triangle : tree.triangles(node))
        for (const int opponent : other_tree.triangles(other)) test(triangle, opponent);
      return;
    }
    const bool open_other =
        node.is_leaf() || (!other.is_leaf() && other.end - other.begin > node.end - node.begin);
    if (open_other) {
      for (const int half : other.halves) between(tree, index, other_tree, half);
    } else {
      for (const int half : node.halves) between(tree, half, other_tree, other_index);
    }
  }

  IntersectingPairs found() {
    std::sort(found_.pairs.begin(), found_.pairs.end());
    return std::move(found_);
  }

 private:
  void test(int a, int b) {
    if (!ClosedBox::around(soup_, a).meets(ClosedBox::around(soup_, b))) return;
    if (is_full()) return;
    const TrianglePair pair{std::min(a, b), std::max(a, b)};
    if (triangles_meet(soup_, pair)) found_.pairs.push_back(pair);
  }

  // Asked only where there is something left to test.
  bool is_full() {
    if (found_.pairs.size() >= most_) found_.all = false;
    return !found_.all;
  }

  const TriangleSoup& soup_;
  std::size_t most_;
  IntersectingPairs found_;
};

}  // namespace

IntersectingPairs intersecting_pairs(const TriangleSoup& soup, const BoxTree& judged,
                                     const BoxTree& rest, std::size_t most) {
  PairSearch search(soup, most);
  if (!judged.empty()) search.within(judged, BoxTree::root);
  if (!judged.empty() && !rest.empty()) search.between(judged, BoxTree::root, rest, BoxTree::root);
  return search.found();
}

}  // namespace ribbon
