#include "player/picture/picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "parallel/parallel.h"

namespace ribbon {

namespace {

void encode(const Color& color, std::uint8_t* rgb) {
  for (int channel = 0; channel < 3; ++channel) rgb[channel] = srgb_byte(color[channel]);
}

}  // namespace

Picture blank_picture(PictureSize size, const Color& color) {
  Picture picture{size, std::vector<std::uint8_t>(3 * size.pixel_count())};
  for (std::size_t i = 0; i < size.pixel_count(); ++i) encode(color, picture.rgb.data() + 3 * i);
  return picture;
}

Picture encode_srgb(const LightPicture& light) {
  Picture picture{light.size, std::vector<std::uint8_t>(3 * light.size.pixel_count())};
  parallel_ranges(light.pixels.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
    srgb_bytes(light.pixels.data() + begin, end - begin, picture.rgb.data() + 3 * begin);
  });
  return picture;
}

void blend(const std::array<std::uint8_t, 3>& ink, int coverage, std::uint8_t* rgb) {
  for (std::size_t channel = 0; channel < 3; ++channel)
    rgb[channel] = static_cast<std::uint8_t>(
        (rgb[channel] * (255 - coverage) + ink[channel] * coverage + 127) / 255);
}

void fill(const PixelBox& box, const Color& color, float opacity, Picture& picture) {
  const auto ink = srgb_bytes(color);
  const int coverage = static_cast<int>(std::lround(255 * opacity));
  for (int y = std::max(box.top, 0); y < std::min(box.bottom, picture.size.height); ++y)
    for (int x = std::max(box.left, 0); x < std::min(box.right, picture.size.width); ++x)
      blend(ink, coverage, picture.pixel(x, y));
}

void paste(const Picture& source, int x, int y, Picture& target) {
  assert(x >= 0 && x + source.size.width <= target.size.width);
  assert(y >= 0 && y + source.size.height <= target.size.height);
  for (int row = 0; row < source.size.height; ++row)
    std::copy_n(source.pixel(0, row), 3 * source.size.width, target.pixel(x, y + row));
}

}  // namespace ribbon
