// A camera as OpenGL takes it.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "player/view/camera.h"

namespace ribbon {

// The distances along the view direction between which depth is told apart.
struct DepthRange {
  float nearest = 0;
  float farthest = 0;
};

// That holds all points of a box, as far as they lie before the camera.
DepthRange depth_range(const Camera& camera, const Eigen::AlignedBox3f& box);

Eigen::Matrix4f clip_from_world(const Camera& camera, const DepthRange& range);

}  // namespace ribbon
