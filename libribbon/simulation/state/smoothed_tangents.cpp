#include "simulation/state/smoothed_tangents.h"

#include <algorithm>

#include "geometry/vectors.h"

namespace ribbon {

using Eigen::Matrix3Xd;

Matrix3Xd smoothed_tangents(const RibbonGrid& grid, const Matrix3Xd& positions) {
  const int reach = grid.across;
  // The edges of a stretch of a column add up to the difference of its ends; their lengths come
  // from running sums.
  Eigen::MatrixXd length_up_to(grid.across, grid.along);
  length_up_to.col(0).setZero();
  for (int i = 1; i < grid.along; ++i)
    for (int j = 0; j < grid.across; ++j)
      length_up_to(j, i) =
          length_up_to(j, i - 1) +
          length_of(positions.col(grid.particle(i, j)) - positions.col(grid.particle(i - 1, j)));

  Matrix3Xd directions(3, grid.particle_count());
  for (int i = 0; i < grid.along; ++i) {
    const int first = std::max(0, i - 1 - reach);
    const int last = std::min(grid.along - 1, i + reach);
    for (int j = 0; j < grid.across; ++j) {
      const double length_m = length_up_to(j, last) - length_up_to(j, first);
      const Eigen::Vector3d chord =
          positions.col(grid.particle(last, j)) - positions.col(grid.particle(first, j));
      directions.col(grid.particle(i, j)) =
          length_m > 0 ? Eigen::Vector3d(chord / length_m) : Eigen::Vector3d::Zero().eval();
    }
  }
  return directions;
}

}  // namespace ribbon
