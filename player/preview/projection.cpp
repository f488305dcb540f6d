#include "player/preview/projection.h"

#include <algorithm>

namespace ribbon {

DepthRange depth_range(const Camera& camera, const Eigen::AlignedBox3f& box) {
  // Nearer than this part of the farthest, depth would lose too much of its precision.
  constexpr float smallest_part = 1e-3F;
  constexpr float margin = 1e-3F;
  const Eigen::Vector3f forward = -camera.world_from_camera.col(2);
  const float middle = forward.dot(box.center() - camera.eye);
  const float half = forward.cwiseAbs().dot(box.sizes()) / 2;
  const float farthest = std::max((middle + half) * (1 + margin), 1e-6F);
  return {std::max((middle - half) * (1 - margin), smallest_part * farthest), farthest};
}

Eigen::Matrix4f clip_from_world(const Camera& camera, const DepthRange& range) {
  const float depth = range.farthest - range.nearest;
  Eigen::Matrix4f clip = Eigen::Matrix4f::Zero();  // from camera coordinates
  clip(0, 0) = 1 / camera.half_width;
  clip(1, 1) = 1 / camera.half_height;
  clip(2, 2) = -(range.farthest + range.nearest) / depth;
  clip(2, 3) = -2 * range.farthest * range.nearest / depth;
  clip(3, 2) = -1;
  Eigen::Matrix4f camera_from_world = Eigen::Matrix4f::Identity();
  camera_from_world.topLeftCorner<3, 3>() = camera.world_from_camera.transpose();
  camera_from_world.topRightCorner<3, 1>() = -camera.world_from_camera.transpose() * camera.eye;
  return clip * camera_from_world;
}

}  // namespace ribbon
