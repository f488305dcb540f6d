#include "player/render/cloth_colors.h"

#include "player/render/cloth_pattern.h"

namespace ribbon {

namespace {

// A texture's white is paper; no cloth returns so much.
constexpr float whitest = 0.85F;

Color textured(const Texture& texture, float along, float across, float reach) {
  return whitest * texture.at(along / texture.aspect(), across, reach);
}

}  // namespace

Color ClothColors::color(float along, float across, bool shows_front, float reach) const {
  const Texture* texture = texture_of(shows_front);
  if (texture != nullptr) return textured(*texture, along, across, reach);
  return shows_front ? cloth_front(along, across, reach) : cloth_back(along, across, reach);
}

void ClothColors::find_colors(const LookBatch& looks, std::size_t count, VectorLanes& colors,
                              std::size_t first) const {
  if (!front) pattern_colors(looks, count, colors, first);
  for (std::size_t i = 0; i < count; ++i) {
    const Texture* texture = texture_of(looks.front[i] > 0);
    if (texture == nullptr) continue;
    const Color color = textured(*texture, looks.x[i], looks.y[i], looks.reach[i]);
    colors.set(first + i, color.matrix());
  }
}

}  // namespace ribbon
