#include "player/picture/color.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ribbon {

namespace {

float linear_from_srgb(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

// thresholds[b]: the linear value from which on byte b + 1 is nearer than byte b.
std::array<float, 255> byte_thresholds() {
  std::array<float, 255> thresholds{};
  for (std::size_t b = 0; b < thresholds.size(); ++b)
    thresholds[b] = linear_from_srgb((static_cast<float>(b) + 0.5F) / 255.0F);
  return thresholds;
}

// Cheaper than one power a pixel, and exact at every rounding border: a table says where to begin.
constexpr int cells = 1024;

std::array<std::uint8_t, cells + 1> cell_guesses(const std::array<float, 255>& thresholds) {
  std::array<std::uint8_t, cells + 1> guesses{};
  for (int cell = 0; cell <= cells; ++cell) {
    const float begin = static_cast<float>(cell) / cells;
    const auto* above = std::upper_bound(thresholds.begin(), thresholds.end(), begin);
    guesses[cell] = static_cast<std::uint8_t>(above - thresholds.begin());
  }
  return guesses;
}

}  // namespace

std::uint8_t srgb_byte(float linear) {
  static const std::array<float, 255> thresholds = byte_thresholds();
  static const std::array<std::uint8_t, cells + 1> guesses = cell_guesses(thresholds);
  if (!(linear > 0)) return 0;
  if (linear >= 1) return 255;
  std::size_t byte = guesses[static_cast<std::size_t>(linear * cells)];
  while (byte < thresholds.size() && linear >= thresholds[byte]) ++byte;
  return static_cast<std::uint8_t>(byte);
}

std::array<std::uint8_t, 3> srgb_bytes(const Color& color) {
  return {srgb_byte(color[0]), srgb_byte(color[1]), srgb_byte(color[2])};
}

Color from_srgb(std::uint32_t rrggbb) {
  const auto channel = [rrggbb](int shift) {
    return linear_from_srgb(static_cast<float>((rrggbb >> shift) & 0xFFU) / 255.0F);
  };
  return {channel(16), channel(8), channel(0)};
}

}  // namespace ribbon
