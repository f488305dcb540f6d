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
  for (int i = 0; i < grid.along; ++i)
    middles.col(i) = positions.middleCols(grid.particle(i, 0), grid.across).rowwise().mean();
  return middles;
}

}  // namespace ribbon
