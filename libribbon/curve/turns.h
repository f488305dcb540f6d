// Turns between directions of the drawing.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "geometry/angles.h"
#include "geometry/vectors.h"

namespace ribbon {

// Positive where b lies counter-clockwise of a.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// By how much b lies counter-clockwise of a: above -pi, at most pi.
inline double turn_from(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return polar_angle(dot(a, b), cross(a, b));
}

// From 0 to pi.
inline double angle_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::abs(turn_from(a, b));
}

}  // namespace ribbon
