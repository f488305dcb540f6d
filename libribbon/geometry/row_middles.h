// The ribbon as a line.
#pragma once

#include <Eigen/Core>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// Of each row the mean of its particles (3 x particles).
template <class Scalar>
Eigen::Matrix<Scalar, 3, Eigen::Dynamic> row_middles(
    const RibbonGrid& grid, const Eigen::Matrix<Scalar, 3, Eigen::Dynamic>& positions) {
  Eigen::Matrix<Scalar, 3, Eigen::Dynamic> middles(3, grid.along);
  middles.setZero();
  for (int i = 0; i < grid.along; ++i)
    for (int j = 0; j < grid.across; ++j) middles.col(i) += positions.col(grid.particle(i, j));
  return middles / static_cast<Scalar>(grid.across);
}

}  // namespace ribbon
