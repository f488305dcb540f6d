#include "player/preview/cloth_texels.h"

#include <algorithm>
#include <cmath>

#include "player/render/cloth_pattern.h"

namespace ribbon {

namespace {

void append_side(const ClothColors& cloth, bool is_front, ClothTexels& texels) {
  const float period = texels.period[is_front ? 0 : 1];
  const auto along_count = static_cast<float>(texels.along);
  const auto across_count = static_cast<float>(texels.across);
  for (int j = 0; j < texels.across; ++j)
    for (int i = 0; i < texels.along; ++i) {
      const float along = (static_cast<float>(i) + 0.5F) / along_count * period;
      const float across = (static_cast<float>(j) + 0.5F) / across_count;
      const Color root = cloth.color(along, across, is_front, 1 / across_count).sqrt();
      for (const float channel : root)
        texels.bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * channel)));
      texels.bytes.push_back(255);
    }
}

// As many texels as the finer of both sides has pixels.
ClothTexels sized_for(const ClothColors& cloth) {
  if (!cloth.front)
    return {pattern_along, pattern_across, Eigen::Vector2f::Constant(pattern_period), {}};
  const Texture& front = *cloth.front;
  const Texture& back = cloth.back ? *cloth.back : front;
  return {std::min(std::max(front.width(), back.width()), most_texels),
          std::min(std::max(front.height(), back.height()), most_texels),
          {front.aspect(), back.aspect()},
          {}};
}

}  // namespace

ClothTexels cloth_texels(const ClothColors& cloth) {
  ClothTexels texels = sized_for(cloth);
  texels.bytes.reserve(std::size_t{2} * 4 * texels.along * texels.across);
  append_side(cloth, true, texels);
  append_side(cloth, false, texels);
  return texels;
}

}  // namespace ribbon
