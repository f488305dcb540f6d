// The piece of a smooth curve between two of the points that it passes through.
#pragma once

#include <Eigen/Core>
#include <cassert>
#include <cmath>

#include "geometry/vectors.h"

namespace ribbon {

// A cubic by its ends and its derivatives there.
struct Cubic {
  Eigen::Vector2d begin, begin_derivative, end, end_derivative;

  // t: 0 to 1.
  [[nodiscard]] Eigen::Vector2d at(double t) const {
    const double u = 1 - t;
    return u * u * (1 + 2 * t) * begin + u * u * t * begin_derivative + t * t * (1 + 2 * u) * end -
           t * t * u * end_derivative;
  }
};

// The derivative at p1 by the knots of p0, p1, p2, for a parameter that grows by 1 over `scale`.
inline Eigen::Vector2d catmull_rom_derivative(const Eigen::Vector2d& p0, const Eigen::Vector2d& p1,
                                              const Eigen::Vector2d& p2, double scale) {
  const double before = std::sqrt(length_of(p1 - p0));
  const double after = std::sqrt(length_of(p2 - p1));
  assert(before > 0 && after > 0);
  return scale * ((p1 - p0) / before - (p2 - p0) / (before + after) + (p2 - p1) / after);
}

// The centripetal Catmull-Rom curve between p1 and p2: the usual one where the points are evenly
// spaced, without loops or overshoot where they are not. Consecutive points must differ.
inline Cubic catmull_rom(const Eigen::Vector2d& p0, const Eigen::Vector2d& p1,
                         const Eigen::Vector2d& p2, const Eigen::Vector2d& p3) {
  const double knots = std::sqrt(length_of(p2 - p1));
  return {p1, catmull_rom_derivative(p0, p1, p2, knots), p2,
          catmull_rom_derivative(p1, p2, p3, knots)};
}

}  // namespace ribbon
