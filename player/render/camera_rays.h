// The rays that look through the pixels of a picture.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "player/picture/picture.h"
#include "player/render/ray_batch.h"
#include "player/render/sampling.h"
#include "player/view/camera.h"

namespace ribbon {

class CameraRays {
 public:
  // Samples look where the patterns say, the same in every pixel.
  CameraRays(const Camera& camera, PictureSize size, const SamplePatterns& patterns);

  [[nodiscard]] Ray ray(int x, int y, int sample) const {
    const Eigen::Vector2f& offset = offsets_[static_cast<std::size_t>(sample)];
    return {eye_, top_left_ + (static_cast<float>(x) + offset.x()) * right_ +
                      (static_cast<float>(y) + offset.y()) * down_};
  }

  // Width of a pixel per length of its ray's direction.
  [[nodiscard]] float spread() const { return right_.norm(); }

 private:
  Eigen::Vector3f eye_;
  Eigen::Vector3f top_left_;  // towards the picture's corner; the others from pixel to pixel
  Eigen::Vector3f right_;
  Eigen::Vector3f down_;
  std::vector<Eigen::Vector2f> offsets_;  // in pixels, from the pixel's top left corner
};

}  // namespace ribbon
