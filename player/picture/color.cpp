#include "player/picture/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ribbon {

namespace {

float linear_from_srgb(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

// Cheaper than one power a pixel, and exact at every rounding border: cells so narrow that no two
// borders lie in one.
constexpr int cells = 4096;

struct ByteTable {
  std::array<float, 256> borders;  // the linear value from which on byte b + 1 is nearer than b
  std::array<std::int32_t, cells + 1> first;  // the byte at the beginning of each cell

  ByteTable() {
    for (std::size_t b = 0; b < 255; ++b)
      borders[b] = linear_from_srgb((static_cast<float>(b) + 0.5F) / 255.0F);
    borders[255] = std::numeric_limits<float>::infinity();
    for (int cell = 0; cell <= cells; ++cell) {
      const float begin = static_cast<float>(cell) / cells;
      const auto* above = std::upper_bound(borders.begin(), borders.end(), begin);
      first[static_cast<std::size_t>(cell)] = static_cast<std::int32_t>(above - borders.begin());
    }
  }

  [[nodiscard]] std::int32_t byte(float linear) const {
    const float some = linear > 0 ? linear : 0.0F;
    const float shown = some < 1 ? some : 1.0F;
    const std::int32_t least = first[static_cast<std::size_t>(static_cast<int>(shown * cells))];
    return least + (shown >= borders[static_cast<std::size_t>(least)] ? 1 : 0);
  }
};

const ByteTable& byte_table() {
  static const ByteTable table;
  return table;
}

}  // namespace

std::uint8_t srgb_byte(float linear) {
  return static_cast<std::uint8_t>(byte_table().byte(linear));
}

void srgb_bytes(const Color* colors, std::size_t count, std::uint8_t* rgb) {
  const ByteTable& table = byte_table();
  const Color* const end = colors + count;
  while (colors != end) {
    // Most pixels show the backdrop, which is the same along a row.
    const Color& color = *colors;
    const Color* const other =
        std::find_if(colors + 1, end, [&](const Color& next) { return !(next == color).all(); });
    const std::array bytes{static_cast<std::uint8_t>(table.byte(color[0])),
                           static_cast<std::uint8_t>(table.byte(color[1])),
                           static_cast<std::uint8_t>(table.byte(color[2]))};
    for (; colors != other; ++colors, rgb += 3) std::copy(bytes.begin(), bytes.end(), rgb);
  }
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
