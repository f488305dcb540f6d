#include "player/picture/png_encoder.h"

#include <gtest/gtest.h>
#include <png.h>

namespace ribbon::png_encoder_test {

Picture read_back(const std::string& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
  EXPECT_EQ(image.format & PNG_FORMAT_FLAG_COLOR, PNG_FORMAT_FLAG_COLOR);
  image.format = PNG_FORMAT_RGB;
  Picture picture{{static_cast<int>(image.width), static_cast<int>(image.height)},
                  std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image))};
  EXPECT_NE(png_image_finish_read(&image, nullptr, picture.rgb.data(), 0, nullptr), 0);
  return picture;
}

Picture colourful(PictureSize size) {
  Picture picture{size, std::vector<std::uint8_t>(3 * size.pixel_count())};
  std::uint32_t state = 1;
  for (auto& byte : picture.rgb)
    byte = static_cast<std::uint8_t>((state = state * 69069 + 1) >> 24);
  return picture;
}

TEST(PngEncoder, pictures_come_back_equal) {
  for (const PictureSize size : {PictureSize{1, 1}, PictureSize{37, 5}, PictureSize{640, 361}}) {
    const Picture picture = colourful(size);
    const Picture back = read_back(png_bytes(picture));
    EXPECT_EQ(back.size, size);
    EXPECT_EQ(back.rgb, picture.rgb);
  }
}

TEST(PngEncoder, files_say_that_they_are_srgb) {
  const std::string bytes = png_bytes(colourful({8, 8}));
  EXPECT_NE(bytes.find("sRGB"), std::string::npos);
  const std::size_t gamma = bytes.find("gAMA");
  ASSERT_NE(gamma, std::string::npos);
  EXPECT_EQ(bytes.substr(gamma + 4, 4), std::string("\0\0\xB1\x8F", 4));  // 45455 = 1e5 / 2.2
  EXPECT_LT(bytes.find("sRGB"), bytes.find("IDAT"));
}

}  // namespace ribbon::png_encoder_test
