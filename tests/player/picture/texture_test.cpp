#include "player/picture/texture.h"

#include <gtest/gtest.h>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "player/picture/png_encoder.h"
#include "result/refusal.h"

namespace ribbon::texture_test {

constexpr std::uint32_t red = 0xC02010;
constexpr std::uint32_t blue = 0x1020C0;

// Columns of red and blue in turns, the top row white.
Texture striped(int width, int height) {
  Picture picture = blank_picture({width, height}, from_srgb(0xFFFFFF));
  for (int y = 1; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int channel = 0; channel < 3; ++channel)
        picture.pixel(x, y)[channel] =
            static_cast<std::uint8_t>((x % 2 == 0 ? red : blue) >> (16 - 8 * channel));
  const auto file = temporary_file("striped.png");
  EXPECT_TRUE(write_png(file, picture));
  return Texture::read(file).value();
}

void expect_near(const Color& color, const Color& expected, float tolerance = 1e-5F) {
  EXPECT_LT((color - expected).abs().maxCoeff(), tolerance) << color << "\n" << expected;
}

TEST(Texture, shows_its_pixels_where_they_are) {
  const Texture texture = striped(8, 4);
  EXPECT_FLOAT_EQ(texture.aspect(), 2);
  expect_near(texture.at(0.5F / 8, 0.5F / 4, 0), from_srgb(red));
  expect_near(texture.at(3.5F / 8, 1.5F / 4, 0), from_srgb(blue));
  expect_near(texture.at(0.5F / 8, 3.5F / 4, 0), from_srgb(0xFFFFFF));
}

TEST(Texture, is_repeated_beyond_its_borders) {
  const Texture texture = striped(8, 4);
  for (const float turns : {-3.0F, 1.0F, 20.0F})
    expect_near(texture.at(turns + 0.5F / 8, 0.3F, 0), texture.at(0.5F / 8, 0.3F, 0));
}

TEST(Texture, a_wide_look_sees_the_mean) {
  const Texture texture = striped(64, 64);
  expect_near(texture.at(0.3F, 0.3F, 0.2F), (from_srgb(red) + from_srgb(blue)) / 2, 1e-3F);
}

TEST(Texture, sides_need_not_be_powers_of_two) {
  const Texture texture = striped(5, 3);
  expect_near(texture.at(0.5F / 5, 0.5F / 3, 0), from_srgb(red));
  const Color mean = texture.at(0.1F, 0.9F, 100);
  EXPECT_TRUE((mean == texture.at(0.7F, 0.2F, 100)).all());
}

TEST(Texture, what_is_no_picture_is_refused) {
  EXPECT_THAT(refusal_of(Texture::read("/no/such.png")), StartsWith("/no/such.png: "));
  const auto text = temporary_file("text.png");
  ASSERT_TRUE(write_file(text, "not a picture"));
  EXPECT_THAT(refusal_of(Texture::read(text)), HasSubstr("is not a PNG"));
  const auto cut = temporary_file("cut.png");
  const std::string whole = png_bytes(blank_picture({64, 64}, from_srgb(red)));
  ASSERT_TRUE(write_file(cut, whole.substr(0, whole.size() / 2)));
  EXPECT_THAT(refusal_of(Texture::read(cut)), HasSubstr("is damaged"));
}

}  // namespace ribbon::texture_test
