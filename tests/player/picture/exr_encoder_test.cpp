#include "player/picture/exr_encoder.h"

#include <ImfRgbaFile.h>
#include <gtest/gtest.h>

#include <vector>

#include "files/files.h"
#include "files/temporary_folder.h"

namespace ribbon::exr_encoder_test {

// Rows from the top left.
std::vector<Imf::Rgba> read_back(const std::string& bytes, PictureSize size) {
  const std::filesystem::path path = temporary_file("light.exr");
  EXPECT_TRUE(write_file(path, bytes));
  Imf::RgbaInputFile file(path.c_str());
  EXPECT_EQ(file.dataWindow().max.x + 1, size.width);
  EXPECT_EQ(file.dataWindow().max.y + 1, size.height);
  std::vector<Imf::Rgba> pixels(size.pixel_count());
  file.setFrameBuffer(pixels.data(), 1, static_cast<std::size_t>(size.width));
  file.readPixels(0, size.height - 1);
  return pixels;
}

TEST(ExrEncoder, light_comes_back_as_half_floats_also_beyond_white) {
  LightPicture picture{{37, 19}, {}};
  for (std::size_t i = 0; i < picture.size.pixel_count(); ++i) {
    const auto x = static_cast<float>(i);
    picture.pixels.emplace_back(x / 300, 40 + x, 1 / (1 + x));
  }
  const auto pixels = read_back(exr_bytes(picture), picture.size);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    EXPECT_EQ(pixels[i].r, half(picture.pixels[i].x()));
    EXPECT_EQ(pixels[i].g, half(picture.pixels[i].y()));
    EXPECT_EQ(pixels[i].b, half(picture.pixels[i].z()));
  }
}

TEST(ExrEncoder, what_is_too_bright_is_the_brightest) {
  const LightPicture picture{{1, 1}, {Color(1e9F, 0, 1)}};
  EXPECT_EQ(static_cast<float>(read_back(exr_bytes(picture), {1, 1})[0].r), 65504.0F);
}

TEST(ExrEncoder, the_same_light_gives_the_same_bytes) {
  const LightPicture picture{{64, 64},
                             std::vector<Color>(std::size_t{64} * 64, Color(0.1F, 2, 0.3F))};
  EXPECT_EQ(exr_bytes(picture), exr_bytes(picture));
}

}  // namespace ribbon::exr_encoder_test
