#include "player/render/camera_rays.h"

#include <cmath>

#include "parallel/vector_loop.h"
#include "player/render/lane_vector.h"

namespace ribbon {

namespace {

// Samples fall off like a tent over the neighbouring pixels, which smooths edges better than a
// pixel's square.
float tent(float uniform) {
  return uniform < 0.5F ? std::sqrt(2 * uniform) - 1 : 1 - std::sqrt(2 - 2 * uniform);
}

}  // namespace

CameraRays::CameraRays(const Camera& camera, PictureSize size, const SamplePatterns& patterns)
    : eye_(camera.eye),
      top_left_(camera.direction(-1, 1)),
      right_((camera.direction(1, 1) - top_left_) / static_cast<float>(size.width)),
      down_((camera.direction(-1, -1) - top_left_) / static_cast<float>(size.height)) {
  for (int s = 0; s < patterns.samples(); ++s) {
    const Eigen::Vector2f point = patterns.point(Pattern::pixel, s, 0, 0);
    offsets_.emplace_back(0.5F + tent(point.x()), 0.5F + tent(point.y()));
  }
}

void CameraRays::look(const Lanes<float>& x, const Lanes<float>& y, std::size_t count,
                      RayBatch& rays) const {
  const LaneVector eye = {eye_.x(), eye_.y(), eye_.z()};
  const LaneVector corner = {top_left_.x(), top_left_.y(), top_left_.z()};
  const LaneVector right = {right_.x(), right_.y(), right_.z()};
  const LaneVector down = {down_.x(), down_.y(), down_.z()};
  vectorised([&]() RIBBON_INLINED {
    const std::size_t end = filled_up(count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i) {
      set_lane(rays.origin, i, eye);
      set_lane(rays.direction, i, corner + x[i] * right + y[i] * down);
    }
  });
  rays.count = count;
}

}  // namespace ribbon
