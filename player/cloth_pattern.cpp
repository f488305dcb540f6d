#include "cloth_pattern.h"

#include <algorithm>
#include <cmath>

namespace ribbon {

namespace {

const Color indigo = from_srgb(0x24406E);
const Color cream = from_srgb(0xEFE3C8);
const Color gold = from_srgb(0xC8963E);
const Color vermilion = from_srgb(0xC2452D);
const Color wine = from_srgb(0x8E2A20);

// 0 below `border`, 1 above it, with a soft step of width `blur` between.
float step(float value, float border, float blur) {
  return std::clamp((value - border) / blur + 0.5F, 0.0F, 1.0F);
}

float distance_to_selvage(float across) {
  return std::min(across, 1.0F - across);
}

// "Waves of the blue sea": discs that overlap like roof tiles, each of concentric arcs, so that
// only fans are left, opening towards the ribbon's second end. Returns how much of the cream thread
// shows.
float waves(float along, float across) {
  constexpr float fans_across = 2;
  constexpr float rows_per_fan = 4;
  const float x = across * fans_across;
  const float y = along * fans_across;
  // A disc reaches half a fan around its centre; of those that hold the point the first lies on
  // top. One always does: the rows stand closer than that.
  for (float row = std::ceil((y - 0.5F) * rows_per_fan);; ++row) {
    const float shift = std::fmod(std::abs(row), 2.0F) / 2;
    const float dx = x - shift - std::round(x - shift);
    const float dy = y - row / rows_per_fan;
    const float radius = 2 * std::sqrt(dx * dx + dy * dy);
    if (radius > 1) continue;
    const float ring = radius * 3 - std::floor(radius * 3);
    return step(ring, 0.72F, 0.12F);
  }
}

}  // namespace

Color cloth_front(float along, float across) {
  const float selvage = distance_to_selvage(across);
  if (selvage < 0.035F) return indigo;
  if (selvage < 0.075F) return gold;
  if (selvage < 0.105F) return indigo;
  return indigo + (cream - indigo) * waves(along, across);
}

Color cloth_back(float /*along*/, float across) {
  const float selvage = distance_to_selvage(across);
  return selvage >= 0.035F && selvage < 0.075F ? wine : vermilion;
}

}  // namespace ribbon
