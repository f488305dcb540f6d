#include "player/preview/cloth_texels.h"

#include <gtest/gtest.h>

#include "files/temporary_folder.h"
#include "player/picture/png_encoder.h"
#include "player/render/cloth_pattern.h"

namespace ribbon::cloth_texels_test {

// What the texel shows, as linear light.
Color light_of(const ClothTexels& texels, int side, int i, int j) {
  const std::size_t at =
      4 * (static_cast<std::size_t>(side * texels.across + j) * texels.along + i);
  const Color root(texels.bytes[at], texels.bytes[at + 1], texels.bytes[at + 2]);
  return (root / 255).square();
}

// Mean difference from the cloth, at texels that are spread all over it.
float difference(int side, Color (*cloth)(float, float, float), float shift) {
  const ClothTexels texels = cloth_texels({});
  float sum = 0;
  constexpr int count = 2000;
  for (int k = 0; k < count; ++k) {
    const int i = k * 37 % texels.along;
    const int j = k * 101 % texels.across;
    const float along =
        (static_cast<float>(i) + 0.5F) / static_cast<float>(texels.along) * texels.period[side] +
        shift;
    const float across = (static_cast<float>(j) + 0.5F) / static_cast<float>(texels.across);
    sum += (light_of(texels, side, i, j) - cloth(along, across, 0)).abs().maxCoeff();
  }
  return sum / count;
}

TEST(ClothTexels, both_sides_are_those_of_the_cloth) {
  EXPECT_LT(difference(0, cloth_front, 0), 0.02F);
  EXPECT_LT(difference(1, cloth_back, 0), 0.005F);
  EXPECT_GT(difference(0, cloth_back, 0), 0.2F);
}

TEST(ClothTexels, the_pattern_begins_anew_after_its_period) {
  EXPECT_LT(difference(0, cloth_front, 7 * 0.5F), 0.02F);
  EXPECT_GT(difference(0, cloth_front, 0.25F), 0.1F);
}

std::shared_ptr<const Texture> texture_of(PictureSize size, const Color& left, const Color& right) {
  Picture picture = blank_picture(size, left);
  for (int y = 0; y < size.height; ++y)
    for (int x = size.width / 2; x < size.width; ++x)
      for (int channel = 0; channel < 3; ++channel)
        picture.pixel(x, y)[channel] = srgb_byte(right[channel]);
  const auto file = temporary_file("texture.png");
  EXPECT_TRUE(write_png(file, picture));
  return std::make_shared<const Texture>(Texture::read(file).value());
}

TEST(ClothTexels, textures_of_different_shapes_each_fill_their_side) {
  const Color red(1, 0, 0);
  const Color green(0, 1, 0);
  const Color blue(0, 0, 1);
  const ClothColors cloth{texture_of({40, 20}, red, green), texture_of({8, 32}, blue, red)};
  const ClothTexels texels = cloth_texels(cloth);
  EXPECT_EQ(texels.along, 40);
  EXPECT_EQ(texels.across, 32);
  EXPECT_EQ(texels.period, Eigen::Vector2f(2, 0.25F));
  EXPECT_GT(light_of(texels, 0, 5, 16)[0], 0.8F);
  EXPECT_GT(light_of(texels, 0, 35, 16)[1], 0.8F);
  EXPECT_GT(light_of(texels, 1, 10, 16)[2], 0.8F);
  EXPECT_GT(light_of(texels, 1, 30, 16)[0], 0.8F);
  const ClothTexels same = cloth_texels({cloth.front, nullptr});
  EXPECT_GT(light_of(same, 1, 5, 10)[0], 0.8F) << "a back without its own shows the front's";
}

TEST(ClothTexels, of_large_textures_are_no_more_than_memory_has_room_for) {
  const ClothTexels texels =
      cloth_texels({texture_of({3000, 4}, Color::Ones(), Color::Ones()), nullptr});
  EXPECT_EQ(texels.along, most_texels);
  EXPECT_EQ(texels.bytes.size(), std::size_t{2} * 4 * most_texels * 4);
}

}  // namespace ribbon::cloth_texels_test
