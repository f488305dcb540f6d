#include "player/view/framing.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "player/view/orbit.h"

namespace ribbon {

Framing::Framing(const View& view, PictureSize size)
    : camera_(camera_towards(view, size)),
      reach_(Eigen::Vector4f::Constant(-std::numeric_limits<float>::infinity())),
      nearest_(-std::numeric_limits<float>::infinity()) {
  const float wide = camera_.half_width * (1 - 2 * free_margin);
  const float high = camera_.half_height * (1 - 2 * free_margin);
  Eigen::Matrix<float, 4, 3> in_camera;
  in_camera << -1, 0, wide, 1, 0, wide, 0, -1, high, 0, 1, high;
  side_ = in_camera * camera_.world_from_camera.transpose();
}

void Framing::include(const Eigen::Matrix3Xf& points) {
  if (points.cols() == 0) return;
  reach_ = reach_.cwiseMax((side_ * points).rowwise().maxCoeff());
  nearest_ = std::max(nearest_, (camera_.world_from_camera.col(2).transpose() * points).maxCoeff());
}

// A point p is right of the left side of the picture when -p.x + wide p.z <= -eye.x + wide eye.z,
// and likewise for the others: opposite sides together bound the eye's distance, and leave its
// place between them.
Camera Framing::camera() const {
  assert(std::isfinite(nearest_));
  const float wide = camera_.half_width * (1 - 2 * free_margin);
  const float high = camera_.half_height * (1 - 2 * free_margin);
  const float needed =
      std::max((reach_[0] + reach_[1]) / (2 * wide), (reach_[2] + reach_[3]) / (2 * high));
  // A single point would pull the eye into itself.
  const float clearance = 1e-4F * std::max(1e-3F, std::abs(nearest_));
  const Eigen::Vector3f eye((reach_[1] - reach_[0]) / 2, (reach_[3] - reach_[2]) / 2,
                            std::max(needed, nearest_ + clearance));
  Camera camera = camera_;
  camera.eye = camera.world_from_camera * eye;
  return camera;
}

float Framing::distance_from(const Eigen::Vector3f& target) const {
  assert(std::isfinite(nearest_));
  const Eigen::Vector3f backward = camera_.world_from_camera.col(2);
  return ((reach_ - side_ * target).array() / (side_ * backward).array()).maxCoeff();
}

}  // namespace ribbon
