// Where lines along which one looks go through a mesh.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace ribbon {

struct HeightRange {
  double low = 0;
  double high = 0;

  void include(const HeightRange& range);
};

// A bounding volume hierarchy over a mesh as it is seen.
class LinesOfSight {
 public:
  // seen: 3 x V, vertices by what the viewer has to his right, below him, and towards him (the
  // height). triangles: 3 x T, of any orientation.
  LinesOfSight(Eigen::Matrix3Xd seen, Eigen::Matrix3Xi triangles);

  // From the lowest to the highest place of the mesh on the line through a place of the view;
  // nothing where the line misses it. Triangles seen edge-on are missed, their neighbours are not.
  [[nodiscard]] std::optional<HeightRange> through(const Eigen::Vector2d& place) const;

 private:
  // Of the triangles `first` to `end` - 1 of the order; a leaf holds one, a node halves them.
  struct Node {
    Eigen::Vector2d low;
    Eigen::Vector2d high;
    int first = 0;
    int end = 0;
    int second_child = 0;  // the first one follows at once
  };

  int add_node(int first, int end);
  void sort_halves(int first, int middle, int end, int coordinate);
  [[nodiscard]] std::optional<double> height_of(int triangle, const Eigen::Vector2d& place) const;

  Eigen::Matrix3Xd seen_;
  Eigen::Matrix3Xi triangles_;
  std::vector<Node> nodes_;
};

}  // namespace ribbon
