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
  // Keeps a reference to `backdrop`.
  BackdropView(const Backdrop& backdrop, const Camera& camera, PictureSize size);

  [[nodiscard]] Color at(int x, int y) const {
    if (pixels_.empty()) return backdrop_.at(y, size_.height);
    return pixels_[static_cast<std::size_t>(y) * size_.width + x];
  }

 private:
  const Backdrop& backdrop_;
  PictureSize size_;
  std::vector<Color> pixels_;  // of an environment; empty: it is the same along a row
};

}  // namespace ribbon
