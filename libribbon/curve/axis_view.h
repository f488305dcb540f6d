// What the viewer of a drawing has to his right, below him and towards him, and where it is in the
// world: he looks from the positive end of the axis.
#pragma once

#include <Eigen/Core>

#include "scene/scene.h"

namespace ribbon {

inline Eigen::Vector3d in_world(const Eigen::Vector3d& seen, Axis axis) {
  if (axis == Axis::y) return {seen.x(), seen.z(), seen.y()};
  if (axis == Axis::z) return {seen.x(), -seen.y(), seen.z()};
  return {seen.z(), -seen.y(), -seen.x()};
}

inline Eigen::Vector3d as_seen(const Eigen::Vector3d& world, Axis axis) {
  if (axis == Axis::y) return {world.x(), world.z(), world.y()};
  if (axis == Axis::z) return {world.x(), -world.y(), world.z()};
  return {-world.z(), -world.y(), world.x()};
}

}  // namespace ribbon
