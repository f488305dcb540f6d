// Pictures in memory: linear light while it is being gathered, 8-bit sRGB when it is done.
#pragma once

#include <array>
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

// Lays `ink` over one pixel, which it covers by `coverage` out of 255.
void blend(const std::array<std::uint8_t, 3>& ink, int coverage, std::uint8_t* rgb);

// From (left, top) to before (right, bottom), in pixels.
struct PixelBox {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

// Lays a colour over a part of the picture, opacity 0 to 1; what falls outside is left out.
void fill(const PixelBox& box, const Color& color, float opacity, Picture& picture);

// Copies `source` into `target` with its top left corner at (x, y); it must fit.
void paste(const Picture& source, int x, int y, Picture& target);

}  // namespace ribbon
