// The ribbon's cloth: a patterned front, a plain back, stripes along both selvages.
#pragma once

#include <cstddef>

#include "player/picture/color.h"
#include "player/render/surface_points.h"

namespace ribbon {

// What fraction of the light each side returns, as linear colours. `along` and `across` are
// measured in ribbon widths: along from the first end, across from 0 to 1. Where the pattern runs
// and how it leans shows how the ribbon is twisted. `blur` is how far a look at the cloth reaches,
// in ribbon widths: what is finer is shown as its mean, since it would only be noise.
Color cloth_front(float along, float across, float blur);
Color cloth_back(float along, float across, float blur);

// The same of `count` looks, whose textures' unit is the ribbon's width: colors from `first` on.
void pattern_colors(const LookBatch& looks, std::size_t count, VectorLanes& colors,
                    std::size_t first);

// After so many ribbon widths the pattern begins anew; as an image it has so many texels.
inline constexpr float pattern_period = 0.5F;
inline constexpr int pattern_along = 128;
inline constexpr int pattern_across = 256;

}  // namespace ribbon
