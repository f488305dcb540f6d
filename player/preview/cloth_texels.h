// The cloth as images that repeat along the ribbon.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "player/render/cloth_colors.h"

namespace ribbon {

// Textures that are larger are shown coarser.
inline constexpr int most_texels = 2048;  // each way

struct ClothTexels {
  int along = 0;
  int across = 0;
  Eigen::Vector2f period;  // of front and back: after so many ribbon widths it begins anew
  // Front, then back; of each row by row from one selvage to the other, four bytes a texel: the
  // square roots of red, green and blue, and 255.
  std::vector<std::uint8_t> bytes;
};

ClothTexels cloth_texels(const ClothColors& cloth);

}  // namespace ribbon
