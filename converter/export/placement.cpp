#include "converter/export/placement.h"

namespace ribbon {

Eigen::Matrix3Xf Placement::place(const Eigen::Matrix3Xf& recorded) const {
  const double factor = scale / metres_per_unit;
  Eigen::Matrix3Xf placed = recorded;
  if (factor != 1) placed = (factor * recorded.cast<double>()).cast<float>();
  if (up == UpAxis::z) {
    placed.row(1).swap(placed.row(2));
    placed.row(1) *= -1;
  }
  return placed;
}

}  // namespace ribbon
