#include "player/preview/composition.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "parallel/parallel.h"
#include "player/render/lighting.h"

namespace ribbon {

namespace {

using Rgb = std::array<std::uint8_t, 3>;

std::array<std::uint8_t, 256> make_srgb_of_roots() {
  std::array<std::uint8_t, 256> bytes{};
  for (std::size_t b = 0; b < bytes.size(); ++b) {
    const float root = static_cast<float>(b) / 255;
    bytes[b] = srgb_byte(root * root);
  }
  return bytes;
}

// A row of the backdrop, as it is and as what is drawn over it is mixed with it.
struct BackdropRow {
  BackdropRow(int y, int height) {
    const Color light = Backdrop().at(y, height);
    for (int channel = 0; channel < 3; ++channel) {
      srgb[channel] = srgb_byte(light[channel]);
      root[channel] = static_cast<std::uint8_t>(std::lround(255 * std::sqrt(light[channel])));
    }
  }
  Rgb srgb{};
  Rgb root{};
};

void compose_row(const std::uint8_t* drawn, int width, const BackdropRow& backdrop,
                 std::uint8_t* target) {
  static const auto srgb = make_srgb_of_roots();
  for (int x = 0; x < width; ++x, drawn += 4, target += 3) {
    const unsigned through = 255U - drawn[3];
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const unsigned mixed = drawn[channel] + (through * backdrop.root[channel] + 127) / 255;
      target[channel] = through == 255 ? backdrop.srgb[channel] : srgb[std::min(mixed, 255U)];
    }
  }
}

}  // namespace

void compose(const std::vector<std::uint8_t>& drawn, const PicturePart& part, Picture& picture) {
  const auto row_bytes = 4 * static_cast<std::size_t>(part.size.width);
  const int height = picture.size.height;
  parallel_ranges(part.size.height, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const int y = height - 1 - part.bottom - static_cast<int>(row);
      compose_row(drawn.data() + row * row_bytes, part.size.width, BackdropRow(y, height),
                  picture.pixel(part.left, y));
    }
  });
}

}  // namespace ribbon
