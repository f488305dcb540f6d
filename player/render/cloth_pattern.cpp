#include "player/render/cloth_pattern.h"

#include <algorithm>
#include <cmath>

namespace ribbon {

namespace {

const Color indigo = from_srgb(0x1F4080);
const Color cream = from_srgb(0xEFE3C8);
const Color gold = from_srgb(0xC8963E);
const Color vermilion = from_srgb(0xC2452D);
const Color wine = from_srgb(0x8E2A20);

// Distances from the selvage, in ribbon widths.
constexpr float stripe_begin = 0.03F;
constexpr float stripe_end = 0.09F;
constexpr float pattern_begin = 0.13F;

// 0 below `border`, 1 above it, with a soft step of width `blur` between.
float step(float value, float border, float blur) {
  return std::clamp((value - border) / blur + 0.5F, 0.0F, 1.0F);
}

float distance_to_selvage(float across) {
  return std::min(across, 1.0F - across);
}

// "Waves of the blue sea": discs as wide as the ribbon that overlap like roof tiles, each of
// concentric arcs, so that only fans are left, opening towards the ribbon's second end. Returns how
// much of the cream thread shows.
float waves(float along, float across) {
  constexpr float rows_per_width = 4;
  constexpr float arcs = 3;
  // A disc reaches half a width around its centre; of those that hold the point the first lies on
  // top. One always does: the rows stand closer than that.
  for (float row = std::ceil((along - 0.5F) * rows_per_width);; ++row) {
    const float shift = std::fmod(std::abs(row), 2.0F) / 2;
    const float dx = across - shift - std::round(across - shift);
    const float dy = along - row / rows_per_width;
    const float radius = 2 * std::sqrt(dx * dx + dy * dy);
    if (radius > 1) continue;
    return step(radius * arcs - std::floor(radius * arcs), 0.74F, 0.1F);
  }
}

}  // namespace

Color cloth_front(float along, float across) {
  const float selvage = distance_to_selvage(across);
  if (selvage < stripe_begin) return indigo;
  if (selvage < stripe_end) return gold;
  if (selvage < pattern_begin) return indigo;
  return indigo + (cream - indigo) * waves(along, across);
}

Color cloth_back(float /*along*/, float across) {
  const float selvage = distance_to_selvage(across);
  return selvage >= stripe_begin && selvage < stripe_end ? wine : vermilion;
}

}  // namespace ribbon
