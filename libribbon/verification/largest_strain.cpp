#include "verification/largest_strain.h"

#include <cmath>

namespace ribbon {

LargestStrain largest_strain(const RibbonGrid& grid, double length_m, double width_m,
                             const LimitedEdges& limited, const Eigen::Matrix3Xf& positions) {
  const double along_m = length_m / (grid.along - 1);
  const double across_m = width_m / (grid.across - 1);
  const double diagonal_m = std::hypot(along_m, across_m);
  LargestStrain largest;
  const auto look_at = [&](int first, int second, double rest_m) {
    const double length =
        (positions.col(second).cast<double>() - positions.col(first).cast<double>()).norm();
    const double strain = std::abs(length / rest_m - 1);
    if (strain > largest.strain) largest = {strain, first, second};
  };
  for (int q = 0; q < grid.quad_count(); ++q) {
    const auto [a, b, c, d] = grid.quad(q);
    if (limited.along) {
      look_at(a, b, along_m);
      look_at(d, c, along_m);
    }
    if (limited.across) {
      look_at(a, d, across_m);
      look_at(b, c, across_m);
    }
    if (limited.diagonals) {
      look_at(a, c, diagonal_m);
      look_at(b, d, diagonal_m);
    }
  }
  return largest;
}

}  // namespace ribbon
