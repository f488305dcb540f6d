#include "player/render/cloth.h"

#include "player/render/cloth_pattern.h"

namespace ribbon {

namespace {

// A texture's white is paper; no cloth returns so much.
constexpr float whitest = 0.85F;

}  // namespace

void Cloth::find_colors(const LookBatch& looks, std::size_t count, VectorLanes& colors,
                        std::size_t first) const {
  if (!front) cloth_colors(looks, count, colors, first);
  for (std::size_t i = 0; i < count; ++i) {
    const Texture* texture = looks.front[i] > 0 || !back ? front.get() : back.get();
    if (texture == nullptr) continue;
    const Color color =
        whitest * texture->at(looks.x[i] / texture->aspect(), looks.y[i], looks.reach[i]);
    colors.set(first + i, color.matrix());
  }
}

}  // namespace ribbon
