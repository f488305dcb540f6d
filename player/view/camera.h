// Where the picture is taken from.
#pragma once

#include <Eigen/Core>

namespace ribbon {

// A pinhole camera. Camera coordinates: x to the right, y up, z towards the viewer.
struct Camera {
  Eigen::Vector3f eye = Eigen::Vector3f::Zero();
  Eigen::Matrix3f world_from_camera = Eigen::Matrix3f::Identity();  // a rotation
  // Half of what is seen at distance 1.
  float half_width = 1;
  float half_height = 1;

  // Direction (not of unit length) of the ray through the picture at x, y: -1 to 1, y up.
  [[nodiscard]] Eigen::Vector3f direction(float x, float y) const {
    return world_from_camera * Eigen::Vector3f(x * half_width, y * half_height, -1.0F);
  }

  // Where a point appears: x, y as above, and its distance along the view direction, which must be
  // positive for x and y to mean anything.
  [[nodiscard]] Eigen::Vector3f project(const Eigen::Vector3f& point) const {
    const Eigen::Vector3f local = world_from_camera.transpose() * (point - eye);
    const float distance = -local.z();
    return {local.x() / (half_width * distance), local.y() / (half_height * distance), distance};
  }
};

}  // namespace ribbon
