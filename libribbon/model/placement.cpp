#include "model/placement.h"

#include <cmath>
#include <limits>

#include "geometry/single_precision.h"

namespace ribbon {

Eigen::Matrix3Xf Placement::place(const Eigen::Matrix3Xf& recorded) const {
  Eigen::Matrix3Xf placed = recorded;
  if (factor() != 1) placed = (factor() * recorded.cast<double>()).cast<float>();
  if (up == UpAxis::z) {
    placed.row(1).swap(placed.row(2));
    placed.row(1) *= -1;
  }
  return placed;
}

double Placement::rounding_m(const Eigen::Matrix3Xf& recorded) const {
  if (factor() == 1 || recorded.cols() == 0) return 0;
  // The sum of all roundings in double precision is far below the tenth that is added.
  constexpr double with_others = 1.1;
  const double smallest_normal = std::numeric_limits<float>::min();
  const double largest = recorded.cwiseAbs().maxCoeff();
  return std::sqrt(3.0) * (with_others * largest_rounding(largest) + smallest_normal / factor());
}

}  // namespace ribbon
