#include "simulation/state/smoothed_tangents.h"

#include <algorithm>

#include "geometry/vectors.h"

namespace ribbon {

using Eigen::Matrix3Xd;

const Matrix3Xd& SmoothedTangents::at(const Matrix3Xd& positions) {
  const int reach = grid_.across;
  // The edges of a stretch of a column add up to the difference of its ends; their lengths come
  // from running sums.
  length_up_to_.resize(grid_.across, grid_.along);
  length_up_to_.col(0).setZero();
  for (int i = 1; i < grid_.along; ++i)
    for (int j = 0; j < grid_.across; ++j)
      length_up_to_(j, i) =
          length_up_to_(j, i - 1) +
          length_of(positions.col(grid_.particle(i, j)) - positions.col(grid_.particle(i - 1, j)));

  directions_.resize(3, grid_.particle_count());
  for (int i = 0; i < grid_.along; ++i) {
    const int first = std::max(0, i - 1 - reach);
    const int last = std::min(grid_.along - 1, i + reach);
    for (int j = 0; j < grid_.across; ++j) {
      const double length_m = length_up_to_(j, last) - length_up_to_(j, first);
      const Eigen::Vector3d chord =
          positions.col(grid_.particle(last, j)) - positions.col(grid_.particle(first, j));
      directions_.col(grid_.particle(i, j)) =
          length_m > 0 ? Eigen::Vector3d(chord / length_m) : Eigen::Vector3d::Zero().eval();
    }
  }
  return directions_;
}

}  // namespace ribbon
