#include "player/render/cloth.h"

#include "player/render/cloth_pattern.h"

namespace ribbon {

namespace {

// A texture's white is paper; no cloth returns so much.
constexpr float whitest = 0.85F;

}  // namespace

Color Cloth::color(float along, float across, bool shows_front, float reach) const {
  const Texture* texture = shows_front || !back ? front.get() : back.get();
  if (texture == nullptr)
    return shows_front ? cloth_front(along, across, reach) : cloth_back(along, across, reach);
  return whitest * texture->at(along / texture->aspect(), across, reach);
}

}  // namespace ribbon
