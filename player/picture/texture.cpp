#include "player/picture/texture.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "files/files.h"

namespace ribbon {

namespace {

constexpr png_uint_32 largest_side = 16384;

// libpng's own reader of whole files, which looks at the header before it asks for memory.
class PngImage {
 public:
  PngImage() { image_.version = PNG_IMAGE_VERSION; }
  ~PngImage() { png_image_free(&image_); }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;

  bool begin(const std::string& bytes) {
    return png_image_begin_read_from_memory(&image_, bytes.data(), bytes.size()) != 0;
  }
  bool finish(std::vector<std::uint8_t>& rgb) {
    image_.format = PNG_FORMAT_RGB;
    rgb.resize(PNG_IMAGE_SIZE(image_));
    const png_color white{255, 255, 255};
    return png_image_finish_read(&image_, &white, rgb.data(), 0, nullptr) != 0;
  }
  [[nodiscard]] png_uint_32 width() const { return image_.width; }
  [[nodiscard]] png_uint_32 height() const { return image_.height; }
  [[nodiscard]] std::string problem() const { return image_.message; }

 private:
  png_image image_{};
};

int wrapped(int index, int count) {
  const int rest = index % count;
  return rest < 0 ? rest + count : rest;
}

}  // namespace

Result<Texture> Texture::read(const std::filesystem::path& file) {
  const auto bytes = read_file(file);
  if (!bytes) return tl::unexpected(bytes.error());
  PngImage image;
  if (!image.begin(*bytes))
    return failure(file.string(), "is not a PNG picture (" + image.problem() + ")",
                   "save the texture as PNG");
  if (image.width() > largest_side || image.height() > largest_side)
    return failure(file.string(), "is too large for a texture",
                   "make it no larger than 16384 x 16384");
  std::vector<std::uint8_t> rgb;
  if (!image.finish(rgb))
    return failure(file.string(), "is damaged (" + image.problem() + ")", "save it again");
  Level finest{static_cast<int>(image.width()), static_cast<int>(image.height()), {}};
  finest.pixels.reserve(rgb.size() / 3);
  for (std::size_t i = 0; i < rgb.size(); i += 3)
    finest.pixels.push_back(
        from_srgb(static_cast<std::uint32_t>(rgb[i] << 16 | rgb[i + 1] << 8 | rgb[i + 2])));
  return Texture(std::move(finest));
}

Texture::Texture(Level finest) {
  levels_.push_back(std::move(finest));
  while (levels_.back().width > 1 || levels_.back().height > 1)
    levels_.push_back(halved(levels_.back()));
}

// The mean of two by two pixels; an odd one at the end is counted with its neighbour.
Texture::Level Texture::halved(const Level& level) {
  Level half{std::max(level.width / 2, 1), std::max(level.height / 2, 1), {}};
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x) {
      const int right = x + 1 == half.width ? level.width : 2 * x + 2;
      const int bottom = y + 1 == half.height ? level.height : 2 * y + 2;
      Color sum = Color::Zero();
      for (int row = 2 * y; row < bottom; ++row)
        for (int column = 2 * x; column < right; ++column)
          sum += level.pixels[static_cast<std::size_t>(row) * level.width + column];
      half.pixels.emplace_back(sum / static_cast<float>((right - 2 * x) * (bottom - 2 * y)));
    }
  return half;
}

std::size_t Texture::bytes() const {
  std::size_t pixels = 0;
  for (const Level& level : levels_) pixels += level.pixels.size();
  return pixels * sizeof(Color);
}

float Texture::aspect() const {
  return static_cast<float>(levels_.front().width) / static_cast<float>(levels_.front().height);
}

Color Texture::interpolated(const Level& level, float x, float y) {
  const float column = (x - std::floor(x)) * static_cast<float>(level.width) - 0.5F;
  const float row = (1 - y) * static_cast<float>(level.height) - 0.5F;
  const int left = static_cast<int>(std::floor(column));
  const int top = static_cast<int>(std::floor(row));
  const float right = column - static_cast<float>(left);
  const float down = row - static_cast<float>(top);
  const auto pixel = [&](int dx, int dy) -> const Color& {
    const int inside = std::clamp(top + dy, 0, level.height - 1);
    return level
        .pixels[static_cast<std::size_t>(inside) * level.width + wrapped(left + dx, level.width)];
  };
  return (pixel(0, 0) * (1 - right) + pixel(1, 0) * right) * (1 - down) +
         (pixel(0, 1) * (1 - right) + pixel(1, 1) * right) * down;
}

Color Texture::at(float x, float y, float reach) const {
  // The finest level whose pixels are no finer than half the look: samples even out the rest.
  const float pixels = reach * static_cast<float>(levels_.front().height) / 2;
  std::size_t level = 0;
  for (float size = 2; size <= pixels && level + 1 < levels_.size(); size *= 2) ++level;
  return interpolated(levels_[level], x, y);
}

}  // namespace ribbon
