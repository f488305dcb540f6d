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

  // Where a sample of any pixel looks, in pixels from the pixel's top left corner.
  [[nodiscard]] const Eigen::Vector2f& offset(std::size_t sample) const { return offsets_[sample]; }
  // The rays that look through these places, in pixels from the picture's top left corner.
  void look(const Lanes<float>& x, const Lanes<float>& y, std::size_t count, RayBatch& rays) const;

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
