// Smoothed tangents of a ribbon that may be wrinkled (paper, footnote 2 and section 5.5).
#pragma once

#include <Eigen/Core>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// Keeps its memory.
class SmoothedTangents {
 public:
  explicit SmoothedTangents(const RibbonGrid& grid) : grid_(grid) {}

  // For each particle: the sum of the edges along its column, of the one that leads to its row and,
  // to either side of that, of as many as the ribbon is particles wide, divided by the sum of their
  // lengths. Length 1 where the ribbon is straight, less where it is crumpled. 3 x particles.
  const Eigen::Matrix3Xd& at(const Eigen::Matrix3Xd& positions);

 private:
  RibbonGrid grid_;
  Eigen::MatrixXd length_up_to_;  // m, of each column of the ribbon, from its first row
  Eigen::Matrix3Xd directions_;
};

}  // namespace ribbon
