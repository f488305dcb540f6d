#include "simulation/contact/friction.h"

#include <algorithm>

namespace ribbon {

using Eigen::Vector3d;

Vector3d friction_impulse(const Vector3d& sliding, const Vector3d& normal, double coefficient,
                          double pressed) {
  const Vector3d across = sliding - normal.dot(sliding) * normal;
  const double length = across.norm();
  return length > 0 ? Vector3d(-std::min(1.0, coefficient * pressed / length) * across)
                    : Vector3d::Zero();
}

}  // namespace ribbon
