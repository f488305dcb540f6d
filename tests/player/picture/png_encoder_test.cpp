#include "player/picture/png_encoder.h"

#include <gtest/gtest.h>
#include <png.h>

#include "player/render/sequence_renderer.h"
#include "player/view/camera_work.h"
#include "recording/sample_recording.h"

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

// What libpng's own writer makes of it at its default level, 6.
std::string default_png(const Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.size.width);
  image.height = static_cast<png_uint_32>(picture.size.height);
  image.format = PNG_FORMAT_RGB;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  EXPECT_NE(
      png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.rgb.data(), 0, nullptr), 0);
  bytes.resize(size);
  return bytes;
}

TEST(PngEncoder, rendered_frames_take_at_most_a_tenth_more_than_with_libpngs_default) {
  write_sample_recording(temporary_file("png.rbn"), 1);
  auto reader = RecordingReader::open(temporary_file("png.rbn")).value();
  const PictureSize size{640, 360};
  const Camera camera = CameraWork(reader, {{three_quarter_view, size}}).camera(0, {});
  SequenceRenderer renderer(reader, RenderSettings{});
  ASSERT_TRUE(renderer.show(0));
  const Picture picture = renderer.picture(camera, size);
  EXPECT_LT(static_cast<double>(png_bytes(picture).size()),
            1.1 * static_cast<double>(default_png(picture).size()));
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
