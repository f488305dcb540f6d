#include "player/reference_pictures.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "player/picture/png_encoder.h"

namespace ribbon {

namespace {

Picture magnified_difference(const Picture& got, const Picture& kept) {
  Picture shown = got;
  for (std::size_t i = 0; i < shown.rgb.size(); ++i)
    shown.rgb[i] =
        static_cast<std::uint8_t>(std::clamp(128 + 8 * (got.rgb[i] - kept.rgb[i]), 0, 255));
  return shown;
}

bool is_far_off(const std::uint8_t* a, const std::uint8_t* b) {
  constexpr int far = 8;
  return std::abs(a[0] - b[0]) > far || std::abs(a[1] - b[1]) > far || std::abs(a[2] - b[2]) > far;
}

}  // namespace

PictureDifference difference(const Picture& a, const Picture& b) {
  double squares = 0;
  double far_off = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) squares += std::pow(a.rgb[i] - b.rgb[i], 2);
  for (std::size_t i = 0; i < a.rgb.size(); i += 3)
    if (is_far_off(&a.rgb[i], &b.rgb[i])) ++far_off;
  const double mean_square = squares / static_cast<double>(a.rgb.size());
  return {10 * std::log10(255.0 * 255.0 / mean_square),
          far_off / static_cast<double>(a.size.pixel_count())};
}

bool is_within_tolerance(const PictureDifference& difference) {
  return difference.decibels >= 45 && difference.far_off <= 0.001;
}

ReferencePictures::ReferencePictures(std::filesystem::path kept, std::filesystem::path found)
    : kept_(std::move(kept)), found_(std::move(found)) {}

testing::AssertionResult ReferencePictures::shows(const std::string& name,
                                                  const Picture& picture) const {
  const auto file = kept_ / (name + ".png");
  if (!std::filesystem::exists(file))
    return testing::AssertionFailure()
           << "there is no " << file << "; if " << write(name + ".png", picture)
           << " looks right, keep it under that name";
  const Picture kept = read_png(file);
  if (kept.size != picture.size)
    return testing::AssertionFailure()
           << "another size than " << file << ": " << write(name + "-got.png", picture);
  const PictureDifference found = difference(picture, kept);
  if (is_within_tolerance(found)) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << "not as " << file << ": " << found.decibels << " dB, " << 100 * found.far_off
         << " % of the pixels are far off; look at " << write(name + "-got.png", picture) << " and "
         << write(name + "-difference.png", magnified_difference(picture, kept));
}

std::filesystem::path ReferencePictures::write(const std::string& file,
                                               const Picture& picture) const {
  std::filesystem::create_directories(found_);
  EXPECT_TRUE(write_png(found_ / file, picture).has_value());
  return found_ / file;
}

Picture read_png(const std::filesystem::path& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0) << path << image.message;
  image.format = PNG_FORMAT_RGB;
  Picture picture{{static_cast<int>(image.width), static_cast<int>(image.height)},
                  std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image))};
  EXPECT_NE(png_image_finish_read(&image, nullptr, picture.rgb.data(), 0, nullptr), 0) << path;
  return picture;
}

}  // namespace ribbon
