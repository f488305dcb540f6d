// Pictures in memory: linear light while it is being gathered, 8-bit sRGB when it is done.
#pragma once

#include <cstdint>
#include <vector>

#include "player/picture/color.h"

namespace ribbon {

struct PictureSize {
  int width = 1280;
  int height = 720;
  [[nodiscard]] std::size_t pixel_count() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  bool operator==(const PictureSize&) const = default;
};

// Linear light of each pixel, row by row from the top left.
struct LightPicture {
  PictureSize size;
  std::vector<Color> pixels;
};

// 8-bit sRGB, three bytes a pixel, row by row from the top left.
struct Picture {
  PictureSize size;
  std::vector<std::uint8_t> rgb;

  [[nodiscard]] std::uint8_t* pixel(int x, int y) {
    return rgb.data() + 3 * (static_cast<std::size_t>(y) * size.width + x);
  }
  [[nodiscard]] const std::uint8_t* pixel(int x, int y) const {
    return rgb.data() + 3 * (static_cast<std::size_t>(y) * size.width + x);
  }
};

// A picture of one colour.
Picture blank_picture(PictureSize size, const Color& color);

// Encodes each pixel by the sRGB transfer function.
Picture encode_srgb(const LightPicture& light);

// Copies `source` into `target` with its top left corner at (x, y); it must fit.
void paste(const Picture& source, int x, int y, Picture& target);

}  // namespace ribbon
