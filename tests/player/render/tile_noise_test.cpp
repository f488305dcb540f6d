#include "player/render/tile_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ribbon::tile_noise_test {

// Gives a pixel samples, the first half of them first.
void sample(TileNoise& noise, int column, int row, const std::vector<float>& samples) {
  float sum = 0;
  float squares = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    sum += samples[i];
    squares += samples[i] * samples[i];
    if (2 * (i + 1) == samples.size() || i + 1 == samples.size())
      noise.update(column, row, static_cast<float>(i + 1), sum, squares);
  }
}

TileNoise even_tile(int width, int height) {
  TileNoise noise;
  noise.begin(width, height);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      sample(noise, column, row, {0.25F, 0.25F, 0.25F, 0.25F});
  return noise;
}

std::bitset<tile_pixels> pixels(const std::vector<std::pair<int, int>>& places) {
  std::bitset<tile_pixels> pixels;
  for (const auto& [column, row] : places) pixels.set(row * tile_side + column);
  return pixels;
}

TEST(TileNoise, where_all_samples_agree_there_is_none) {
  const TileNoise noise = even_tile(16, 16);
  EXPECT_EQ(noise.error(), 0);
  EXPECT_TRUE(noise.most_worth_doubling(4096).none());
}

TEST(TileNoise, is_half_of_the_difference_of_the_halves_means) {
  TileNoise noise = even_tile(2, 1);
  sample(noise, 1, 0, {0.2F, 0.2F, 0.3F, 0.3F});  // means 0.2 and 0.3, of all 0.25
  // Near 0.25 the picture's level is 255 sqrt(0.25), whose slope is 255: half of 0.1 is 12.75
  // levels, and half of the pixels have none.
  EXPECT_NEAR(noise.error(), 12.75F / std::sqrt(2.0F), 0.01F);
}

TEST(TileNoise, samples_that_differ_alike_in_both_halves_are_none) {
  TileNoise noise = even_tile(1, 1);
  sample(noise, 0, 0, {0, 0.5F, 0.5F, 0});
  EXPECT_EQ(noise.error(), 0);
  EXPECT_EQ(noise.most_worth_doubling(4096), pixels({{0, 0}})) << "but more samples may help";
}

TEST(TileNoise, more_samples_help_most_where_they_differ_and_beside_it) {
  TileNoise noise = even_tile(16, 16);
  sample(noise, 0, 7, {0, 0.5F, 0.5F, 0.1F});
  EXPECT_EQ(noise.most_worth_doubling(4096),
            pixels({{0, 6}, {1, 6}, {0, 7}, {1, 7}, {0, 8}, {1, 8}}));
}

TEST(TileNoise, what_differs_far_less_can_wait) {
  TileNoise noise = even_tile(16, 16);
  sample(noise, 0, 0, {0, 0.5F, 0.5F, 0});
  sample(noise, 15, 15, {0.2F, 0.3F, 0.3F, 0.2F});
  EXPECT_TRUE(noise.most_worth_doubling(4096).test(0));
  EXPECT_FALSE(noise.most_worth_doubling(4096).test(tile_pixels - 1));
}

TEST(TileNoise, samples_are_worth_what_they_take_from_the_squared_error) {
  TileNoise noise = even_tile(1, 1);
  sample(noise, 0, 0, {0.2F, 0.2F, 0.3F, 0.3F});
  // 12.75 levels by the halves; the variance of the mean, were samples independent, is a third of
  // the square of that. A fifth sample takes a fourth of it.
  constexpr float square = 12.75F * 12.75F;
  constexpr float gain = (0.8F * square + 0.2F * square / 3) / 4;
  EXPECT_TRUE(noise.worth_doubling(0.99F * gain, 8).any());
  EXPECT_TRUE(noise.worth_doubling(1.01F * gain, 8).none());
}

TEST(TileNoise, nobody_gets_more_than_the_most) {
  TileNoise noise = even_tile(1, 1);
  sample(noise, 0, 0, {0, 0.5F, 0.5F, 0});
  EXPECT_TRUE(noise.worth_doubling(1, 8).any());
  EXPECT_TRUE(noise.worth_doubling(1, 7).none());
  EXPECT_TRUE(noise.most_worth_doubling(8).any());
  EXPECT_TRUE(noise.most_worth_doubling(7).none());
}

}  // namespace ribbon::tile_noise_test
