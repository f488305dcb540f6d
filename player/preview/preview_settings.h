// How previews are drawn.
#pragma once

#include "player/render/cloth_colors.h"

namespace ribbon {

// Larger pictures are drawn in parts, so that memory stays bounded.
inline constexpr int largest_preview_part = 2048;  // pixels, each way

struct PreviewSettings {
  bool antialiased = true;  // edges with four samples a pixel
  ClothColors cloth = {};
  int threads = 0;  // at most so many; 0: as many as there are cores
};

}  // namespace ribbon
