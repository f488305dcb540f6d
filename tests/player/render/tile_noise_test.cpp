#include "player/render/tile_noise.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace ribbon::tile_noise_test {

// A tile's noise, and the sums of the samples that it has learnt of.
struct SampledTile {
  TileNoise noise;
  std::array<Eigen::Array4f, tile_pixels> light;
  std::array<float, tile_pixels> squared_light{};

  SampledTile(int width, int height) {
    noise.begin(width, height);
    light.fill(Eigen::Array4f::Zero());
  }

  // Gives a pixel grey samples, the first half of them first.
  void sample(int column, int row, const std::vector<float>& samples) {
    const std::size_t place = place_in_tile(column, row);
    light[place].setZero();
    squared_light[place] = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      light[place] += Eigen::Array4f(samples[i], samples[i], samples[i], 1);
      squared_light[place] += samples[i] * samples[i];
      if (2 * (i + 1) == samples.size() || i + 1 == samples.size())
        noise.update(light, squared_light);
    }
  }
};

SampledTile even_tile(int width, int height) {
  SampledTile tile(width, height);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      tile.sample(column, row, {0.25F, 0.25F, 0.25F, 0.25F});
  return tile;
}

std::bitset<tile_pixels> pixels(const std::vector<std::pair<int, int>>& places) {
  std::bitset<tile_pixels> pixels;
  for (const auto& [column, row] : places) pixels.set(row * tile_side + column);
  return pixels;
}

TEST(TileNoise, where_all_samples_agree_there_is_none) {
  const SampledTile tile = even_tile(16, 16);
  EXPECT_EQ(tile.noise.error(), 0);
  EXPECT_TRUE(tile.noise.most_worth_doubling(4096).none());
}

TEST(TileNoise, is_half_of_the_difference_of_the_halves_means) {
  SampledTile tile = even_tile(2, 1);
  tile.sample(1, 0, {0.2F, 0.2F, 0.3F, 0.3F});  // means 0.2 and 0.3, of all 0.25
  // Near 0.25 the picture's level is 255 sqrt(0.25), whose slope is 255: half of 0.1 is 12.75
  // levels, and half of the pixels have none.
  EXPECT_NEAR(tile.noise.error(), 12.75F / std::sqrt(2.0F), 0.01F);
}

TEST(TileNoise, samples_that_differ_alike_in_both_halves_are_none) {
  SampledTile tile = even_tile(1, 1);
  tile.sample(0, 0, {0, 0.5F, 0.5F, 0});
  EXPECT_EQ(tile.noise.error(), 0);
  EXPECT_EQ(tile.noise.most_worth_doubling(4096), pixels({{0, 0}})) << "but more samples may help";
}

TEST(TileNoise, more_samples_help_most_where_they_differ_and_beside_it) {
  SampledTile tile = even_tile(16, 16);
  tile.sample(0, 7, {0, 0.5F, 0.5F, 0.1F});
  EXPECT_EQ(tile.noise.most_worth_doubling(4096),
            pixels({{0, 6}, {1, 6}, {0, 7}, {1, 7}, {0, 8}, {1, 8}}));
}

TEST(TileNoise, what_differs_far_less_can_wait) {
  SampledTile tile = even_tile(16, 16);
  tile.sample(0, 0, {0, 0.5F, 0.5F, 0});
  tile.sample(15, 15, {0.2F, 0.3F, 0.3F, 0.2F});
  EXPECT_TRUE(tile.noise.most_worth_doubling(4096).test(0));
  EXPECT_FALSE(tile.noise.most_worth_doubling(4096).test(tile_pixels - 1));
}

TEST(TileNoise, samples_are_worth_what_they_take_from_the_squared_error) {
  SampledTile tile = even_tile(1, 1);
  tile.sample(0, 0, {0.2F, 0.2F, 0.3F, 0.3F});
  // 12.75 levels by the halves; the variance of the mean, were samples independent, is a third of
  // the square of that. A fifth sample takes a fourth of it.
  constexpr float square = 12.75F * 12.75F;
  constexpr float gain = (0.8F * square + 0.2F * square / 3) / 4;
  EXPECT_TRUE(tile.noise.worth_doubling(0.99F * gain, 8).any());
  EXPECT_TRUE(tile.noise.worth_doubling(1.01F * gain, 8).none());
}

TEST(TileNoise, nobody_gets_more_than_the_most) {
  SampledTile tile = even_tile(1, 1);
  tile.sample(0, 0, {0, 0.5F, 0.5F, 0});
  EXPECT_TRUE(tile.noise.worth_doubling(1, 8).any());
  EXPECT_TRUE(tile.noise.worth_doubling(1, 7).none());
  EXPECT_TRUE(tile.noise.most_worth_doubling(8).any());
  EXPECT_TRUE(tile.noise.most_worth_doubling(7).none());
}

}  // namespace ribbon::tile_noise_test
