#include "player/render/camera_rays.h"

#include <cmath>

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

}  // namespace ribbon
