// Turns between directions of the drawing.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace ribbon {

// Positive where b lies counter-clockwise of a.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// From 0 to pi.
inline double angle_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::abs(std::atan2(cross(a, b), a.dot(b)));
}

}  // namespace ribbon
