#include "player/preview/cloth_texels.h"

#include <cmath>

#include "player/render/cloth_pattern.h"

namespace ribbon {

namespace {

using SideColor = Color (*)(float along, float across, float blur);

void append_side(SideColor cloth, std::vector<std::uint8_t>& texels) {
  for (int j = 0; j < texels_across; ++j)
    for (int i = 0; i < texels_along; ++i) {
      const float along = (static_cast<float>(i) + 0.5F) / texels_along * pattern_period;
      const float across = (static_cast<float>(j) + 0.5F) / texels_across;
      const Color root = cloth(along, across, 1.0F / texels_across).sqrt();
      for (const float channel : root)
        texels.push_back(static_cast<std::uint8_t>(std::lround(255 * channel)));
      texels.push_back(255);
    }
}

}  // namespace

std::vector<std::uint8_t> cloth_texels() {
  std::vector<std::uint8_t> texels;
  texels.reserve(std::size_t{2} * 4 * texels_along * texels_across);
  append_side(cloth_front, texels);
  append_side(cloth_back, texels);
  return texels;
}

}  // namespace ribbon
