// The backdrop as one picture shows it.
#pragma once

#include <vector>

#include "player/picture/picture.h"
#include "player/render/lighting.h"
#include "player/view/camera.h"

namespace ribbon {

// One colour for each pixel, whatever stands before a part of it: tiles in which nothing stands and
// the others show the same.
class BackdropView {
 public:
  BackdropView(const Backdrop& backdrop, const Camera& camera, PictureSize size);

  [[nodiscard]] Color at(int x, int y) const {
    if (pixels_.empty()) return rows_[static_cast<std::size_t>(y)];
    return pixels_[static_cast<std::size_t>(y) * width_ + x];
  }

 private:
  std::size_t width_;
  std::vector<Color> rows_;    // where it is the same along a row
  std::vector<Color> pixels_;  // of an environment
};

}  // namespace ribbon
