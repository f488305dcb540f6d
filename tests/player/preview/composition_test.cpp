#include "player/preview/composition.h"

#include <gtest/gtest.h>

#include "player/render/lighting.h"

namespace ribbon::composition_test {

using Pixel = std::array<int, 3>;

Pixel pixel(const Picture& picture, int x, int y) {
  const std::uint8_t* rgb = picture.pixel(x, y);
  return {rgb[0], rgb[1], rgb[2]};
}

// All of a picture of so many pixels, drawn alike.
Picture composed(PictureSize size, const std::array<std::uint8_t, 4>& drawn) {
  std::vector<std::uint8_t> pixels;
  for (std::size_t i = 0; i < size.pixel_count(); ++i)
    pixels.insert(pixels.end(), drawn.begin(), drawn.end());
  Picture picture = blank_picture(size, Color::Zero());
  compose(pixels, {0, 0, size}, picture);
  return picture;
}

TEST(Composition, what_is_not_drawn_is_the_backdrop) {
  const Picture picture = composed({1, 100}, {0, 0, 0, 0});
  const Backdrop backdrop;
  for (const int y : {0, 50, 99}) {
    const Color light = backdrop.at(y, 100);
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_EQ(pixel(picture, 0, y)[channel], srgb_byte(light[channel])) << y;
  }
}

TEST(Composition, what_is_drawn_becomes_srgb) {
  const float root = 180.0F / 255;
  EXPECT_EQ(pixel(composed({1, 1}, {180, 255, 0, 255}), 0, 0),
            (Pixel{srgb_byte(root * root), 255, 0}));
}

TEST(Composition, black_at_half_opacity_halves_the_root_of_what_is_behind) {
  const Backdrop backdrop;
  const Picture picture = composed({1, 1}, {0, 0, 0, 128});
  const Color behind = backdrop.at(0, 1);
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(pixel(picture, 0, 0)[channel], srgb_byte(behind[channel] / 4), 2);
}

TEST(Composition, a_part_goes_to_its_place) {
  Picture picture = blank_picture({4, 3}, Color::Zero());
  // Two pixels above each other: red below, green above.
  compose({255, 0, 0, 255, 0, 255, 0, 255}, {2, 1, {1, 2}}, picture);
  EXPECT_EQ(pixel(picture, 2, 1), (Pixel{255, 0, 0}));
  EXPECT_EQ(pixel(picture, 2, 0), (Pixel{0, 255, 0}));
  EXPECT_EQ(pixel(picture, 2, 2), (Pixel{0, 0, 0}));
  EXPECT_EQ(pixel(picture, 1, 1), (Pixel{0, 0, 0}));
}

}  // namespace ribbon::composition_test
