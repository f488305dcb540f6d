// Lines with smooth edges.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "player/picture/picture.h"

namespace ribbon {

// Gathers lines of one ink and lays them over a picture. Where lines join or cross, a pixel gets
// its ink once. Places are in pixels, (0, 0) the picture's top left corner.
class Strokes {
 public:
  explicit Strokes(PictureSize size);

  // With round ends; opacity 0 to 1. What falls outside the picture is left out. All must be
  // finite.
  void add(const Eigen::Vector2f& begin, const Eigen::Vector2f& end, float width,
           float opacity = 1);

  void draw(const Color& ink, Picture& picture) const;

 private:
  PictureSize size_;
  std::vector<std::uint8_t> coverage_;  // of each pixel, out of 255
};

}  // namespace ribbon
