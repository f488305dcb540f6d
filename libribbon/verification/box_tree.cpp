#include "verification/box_tree.h"

#include <algorithm>
#include <numeric>

namespace ribbon {

namespace {

constexpr int most_in_a_leaf = 4;

}  // namespace

ClosedBox ClosedBox::around(const TriangleSoup& soup, int triangle) {
  const Eigen::Array3f a = soup.corner(triangle, 0).array();
  const Eigen::Array3f b = soup.corner(triangle, 1).array();
  const Eigen::Array3f c = soup.corner(triangle, 2).array();
  return {a.min(b).min(c), a.max(b).max(c)};
}

double ClosedBox::squared_distance(const ClosedBox& box) const {
  const Eigen::Array3d below = box.low.cast<double>() - high.cast<double>();
  const Eigen::Array3d above = low.cast<double>() - box.high.cast<double>();
  return below.max(above).max(0.0).square().sum();
}

BoxTree::BoxTree(const TriangleSoup& soup, int first, int last) : triangles_(last - first) {
  if (triangles_.empty()) return;
  std::iota(triangles_.begin(), triangles_.end(), first);
  std::vector<ClosedBox> boxes;
  boxes.reserve(triangles_.size());
  for (const int triangle : triangles_) boxes.push_back(ClosedBox::around(soup, triangle));
  nodes_.reserve(triangles_.size());
  build(boxes, first, 0, last - first);
}

// Splits at the median along the longest side: both halves get equally many triangles wherever they
// lie, so the depth is bounded.
int BoxTree::build(const std::vector<ClosedBox>& boxes, int first, int begin, int end) {
  const int index = static_cast<int>(nodes_.size());
  Node node{boxes[triangles_[begin] - first], begin, end};
  for (int k = begin + 1; k < end; ++k) node.box.include(boxes[triangles_[k] - first]);
  nodes_.push_back(node);
  if (end - begin <= most_in_a_leaf) return index;
  int axis = 0;
  (node.box.high.cast<double>() - node.box.low.cast<double>()).maxCoeff(&axis);
  const int middle = (begin + end) / 2;
  const auto centre = [&](int triangle) {
    const ClosedBox& box = boxes[triangle - first];
    return static_cast<double>(box.low[axis]) + static_cast<double>(box.high[axis]);
  };
  std::nth_element(triangles_.begin() + begin, triangles_.begin() + middle,
                   triangles_.begin() + end, [&](int a, int b) { return centre(a) < centre(b); });
  const int lower = build(boxes, first, begin, middle);
  const int upper = build(boxes, first, middle, end);
  nodes_[index].halves = {lower, upper};
  return index;
}

}  // namespace ribbon
