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

// As std::floor, which is a call of the C library on the plainest processors.
float rounded_down(float number) {
  const auto whole = static_cast<float>(static_cast<int>(number));
  return number < whole ? whole - 1 : whole;
}

// 0 below `border`, 1 above it, with a soft step of width `blur` between.
float step(float value, float border, float blur) {
  return std::clamp((value - border) / blur + 0.5F, 0.0F, 1.0F);
}

float distance_to_selvage(float across) {
  return std::min(across, 1.0F - across);
}

// 1 on the stripe, 0 beside it.
float stripe(float selvage, float blur) {
  const float soft = std::max(blur, 1e-6F);
  return step(selvage, stripe_begin, soft) - step(selvage, stripe_end, soft);
}

// "Waves of the blue sea": discs as wide as the ribbon that overlap like roof tiles, each of
// concentric arcs, so that only fans are left, opening towards the ribbon's second end. Returns how
// much of the cream thread shows.
float waves(float along, float across, float blur) {
  constexpr float rows_per_width = 4;
  constexpr float arcs = 3;
  constexpr float thread_begin = 0.74F;  // of each arc
  constexpr float mean = 0.325F;         // of the thread over all discs, summed up numerically
  // Arcs are a sixth of a width apart; from a look that spans one on, only their mean is seen.
  const float arcs_seen = blur * 2 * arcs;
  if (arcs_seen >= 1) return mean;
  // A disc reaches half a width around its centre; of those that hold the point the first lies on
  // top. One always does: the rows stand closer than that.
  for (float row = -rounded_down((0.5F - along) * rows_per_width);; ++row) {
    const float shift = row / 2 - rounded_down(row / 2);
    const float dx = across - shift - rounded_down(across - shift + 0.5F);
    const float dy = along - row / rows_per_width;
    const float squared_distance = dx * dx + dy * dy;
    if (squared_distance > 0.25F) continue;
    const float radius = 2 * std::sqrt(squared_distance);
    const float arc = radius * arcs - rounded_down(radius * arcs);
    const float thread = step(arc, thread_begin, std::max(0.1F, arcs_seen));
    return thread + (mean - thread) * arcs_seen * arcs_seen;
  }
}

}  // namespace

Color cloth_front(float along, float across, float blur) {
  const float selvage = distance_to_selvage(across);
  const float on_stripe = stripe(selvage, blur);
  const float patterned = step(selvage, pattern_begin, std::max(blur, 1e-6F));
  Color color = indigo;
  if (patterned > 0) color += (cream - indigo) * (patterned * waves(along, across, blur));
  return color + (gold - color) * on_stripe;
}

Color cloth_back(float /*along*/, float across, float blur) {
  return vermilion + (wine - vermilion) * stripe(distance_to_selvage(across), blur);
}

}  // namespace ribbon
