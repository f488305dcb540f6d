#include "model/point_bounds.h"

namespace ribbon {

// Four points at a time, which the processor compares at once.
PointBounds bounds_of(const Eigen::Matrix3Xf& points) {
  using FourPoints = Eigen::Array<float, 12, 1>;
  if (points.cols() == 0) return {};
  const Eigen::Index fours = points.cols() / 4;
  const Eigen::Map<const Eigen::Array<float, 12, Eigen::Dynamic>> packed(points.data(), 12, fours);
  FourPoints least = points.col(0).replicate<4, 1>();
  FourPoints largest = least;
  for (Eigen::Index four = 0; four < fours; ++four) {
    least = least.min(packed.col(four));
    largest = largest.max(packed.col(four));
  }
  PointBounds bounds{.least = least.reshaped(3, 4).rowwise().minCoeff(),
                     .largest = largest.reshaped(3, 4).rowwise().maxCoeff()};
  for (Eigen::Index point = 4 * fours; point < points.cols(); ++point) {
    bounds.least = bounds.least.cwiseMin(points.col(point));
    bounds.largest = bounds.largest.cwiseMax(points.col(point));
  }
  return bounds;
}

}  // namespace ribbon
