// How far points reach along each axis.
#pragma once

#include <Eigen/Core>

namespace ribbon {

// The smallest and the largest coordinates of some points.
struct PointBounds {
  Eigen::Vector3f least = Eigen::Vector3f::Zero();
  Eigen::Vector3f largest = Eigen::Vector3f::Zero();
};

// Zero where there are no points.
PointBounds bounds_of(const Eigen::Matrix3Xf& points);

}  // namespace ribbon
