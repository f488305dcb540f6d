#include "simulation/contact/friction.h"

#include <algorithm>

#include "geometry/vectors.h"

namespace ribbon {

using Eigen::Vector3d;

Vector3d friction_impulse(const Vector3d& sliding, const Vector3d& normal, double coefficient,
                          double pressed) {
  const Vector3d across = sliding - dot(normal, sliding) * normal;
  const double length = length_of(across);
  return length > 0 ? Vector3d(-std::min(1.0, coefficient * pressed / length) * across)
                    : Vector3d::Zero();
}

}  // namespace ribbon
