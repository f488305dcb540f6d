#include "player/preview/cloth_texels.h"

#include <gtest/gtest.h>

#include "player/render/cloth_pattern.h"

namespace ribbon::cloth_texels_test {

// What the texel shows, as linear light.
Color light_of(const std::vector<std::uint8_t>& texels, int side, int i, int j) {
  const std::size_t at =
      4 * (static_cast<std::size_t>(side * texels_across + j) * texels_along + i);
  const Color root(texels[at], texels[at + 1], texels[at + 2]);
  return (root / 255).square();
}

// Mean difference from the cloth, at texels that are spread all over it.
float difference(int side, Color (*cloth)(float, float, float), float shift) {
  const auto texels = cloth_texels();
  float sum = 0;
  constexpr int count = 2000;
  for (int k = 0; k < count; ++k) {
    const int i = k * 37 % texels_along;
    const int j = k * 101 % texels_across;
    const float along = (static_cast<float>(i) + 0.5F) / texels_along * pattern_period + shift;
    const float across = (static_cast<float>(j) + 0.5F) / texels_across;
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
  EXPECT_LT(difference(0, cloth_front, 7 * pattern_period), 0.02F);
  EXPECT_GT(difference(0, cloth_front, pattern_period / 2), 0.1F);
}

}  // namespace ribbon::cloth_texels_test
