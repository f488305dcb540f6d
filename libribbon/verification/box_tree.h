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
  static constexpr int root = 0;
  // The triangles of a node.
  [[nodiscard]] std::span<const int> triangles(const Node& node) const {
    return std::span(triangles_).subspan(node.begin, node.end - node.begin);
  }

 private:
  int build(const std::vector<ClosedBox>& boxes, int first, int begin, int end);

  std::vector<Node> nodes_;
  std::vector<int> triangles_;
};

}  // namespace ribbon
