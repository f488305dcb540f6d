#include "model/placement.h"

#include <cmath>
#include <limits>

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
  // Single precision rounds a coordinate by at most this part of it; the sum of all roundings in
  // double precision is far below the tenth that is added.
  constexpr double part = 1.1 * 0x1p-24;
  const double smallest_normal = std::numeric_limits<float>::min();
  const double largest = recorded.cwiseAbs().maxCoeff();
  return std::sqrt(3.0) * (part * largest + smallest_normal / factor());
}

}  // namespace ribbon
