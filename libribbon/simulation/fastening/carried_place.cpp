#include "simulation/fastening/carried_place.h"

#include <algorithm>

#include "geometry/vectors.h"

namespace ribbon {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

CarriedPlace::CarriedPlace(const Vector3d& from, const Matrix3Xd& way)
    : corners_(3, way.cols() + 1), ends_m_{0} {
  corners_.col(0) = from;
  corners_.rightCols(way.cols()) = way;
  for (Index i = 1; i < corners_.cols(); ++i)
    ends_m_.push_back(ends_m_.back() + length_of((corners_.col(i) - corners_.col(i - 1)).eval()));
}

Vector3d CarriedPlace::after(double distance_m) const {
  const double gone_m = gone_m_ + distance_m;
  const auto next = std::upper_bound(ends_m_.begin(), ends_m_.end(), gone_m);
  if (next == ends_m_.end()) return corners_.rightCols<1>();
  const auto i = static_cast<Index>(next - ends_m_.begin());
  const double begin_m = *(next - 1);
  const double t = (gone_m - begin_m) / (*next - begin_m);
  return corners_.col(i - 1) + t * (corners_.col(i) - corners_.col(i - 1));
}

void CarriedPlace::go_on(double distance_m) {
  gone_m_ = std::min(ends_m_.back(), gone_m_ + distance_m);
}

// A take may go on with a shorter way.
void CarriedPlace::visit_state(StateArchive& archive) {
  auto& [corners, ends, gone] = *this;
  double told_m = gone;
  archive.visit(told_m);
  if (told_m < 0)
    archive.refuse("a hand carries something from before its begin");
  else
    gone = told_m;
}

}  // namespace ribbon
