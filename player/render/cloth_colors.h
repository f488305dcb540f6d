// What the ribbon's cloth looks like.
#pragma once

#include <cstddef>
#include <memory>

#include "player/picture/color.h"
#include "player/picture/texture.h"
#include "player/render/surface_points.h"

namespace ribbon {

// Without textures the built-in pattern. A texture is as high as the ribbon is wide and is repeated
// along it; a back without one of its own shows the front's.
struct ClothColors {
  std::shared_ptr<const Texture> front;
  std::shared_ptr<const Texture> back;

  // What fraction of the light it returns: `along` and `across` in ribbon widths, as is `reach`,
  // how wide the look is.
  [[nodiscard]] Color color(float along, float across, bool shows_front, float reach) const;
  // The same where `count` looks fall, whose x is measured along and
  // whose y across, both in ribbon widths: colors from `first` on.
  void find_colors(const LookBatch& looks, std::size_t count, VectorLanes& colors,
                   std::size_t first) const;

 private:
  // None: the built-in pattern.
  [[nodiscard]] const Texture* texture_of(bool shows_front) const {
    return shows_front || !back ? front.get() : back.get();
  }
};

}  // namespace ribbon
