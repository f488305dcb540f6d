#include "player/render/tile_noise.h"

#include <algorithm>
#include <cmath>

namespace ribbon {

namespace {

// Of light, in squared 8-bit levels where the picture shows `mean`; sRGB is near enough to a square
// root here.
float in_levels(float square, float mean) {
  constexpr float darkest = 0.002F;
  return 127.5F * 127.5F * square / std::max(mean, darkest);
}

std::bitset<tile_pixels> those_of(const std::array<float, tile_pixels>& worth, float least) {
  std::bitset<tile_pixels> pixels;
  for (std::size_t pixel = 0; pixel < worth.size(); ++pixel)
    pixels[pixel] = worth[pixel] > 0 && worth[pixel] >= least;
  return pixels;
}

}  // namespace

void TileNoise::begin(int width, int height) {
  width_ = width;
  height_ = height;
  pixels_.fill({});
}

void TileNoise::update(int column, int row, float samples, float luminance,
                       float squared_luminance) {
  Pixel& pixel = pixels_[place_in_tile(column, row)];
  const float first_half = pixel.mean;
  pixel.samples = samples;
  pixel.mean = luminance / samples;
  const float half_difference = pixel.mean - first_half;
  pixel.squared_error = in_levels(half_difference * half_difference, pixel.mean);
  const float variance = std::max(0.0F, squared_luminance / samples - pixel.mean * pixel.mean);
  pixel.variance = in_levels(variance / std::max(samples - 1, 1.0F), pixel.mean);
  // The halves tell more, but that those of few samples agree may be chance.
  constexpr float trust_in_halves = 0.8F;
  pixel.likely_error =
      trust_in_halves * pixel.squared_error + (1 - trust_in_halves) * pixel.variance;
}

float TileNoise::error() const {
  float sum = 0;
  for (const Pixel& pixel : pixels_) sum += pixel.squared_error;
  return std::sqrt(sum / static_cast<float>(width_ * height_));
}

// A pixel whose samples agree may have missed what its neighbours found.
float TileNoise::mean_around(int column, int row, float Pixel::*number) const {
  float sum = 0;
  int count = 0;
  for (int y = std::max(row - 1, 0); y <= std::min(row + 1, height_ - 1); ++y)
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, width_ - 1); ++x, ++count)
      sum += pixels_[place_in_tile(x, y)].*number;
  return sum / static_cast<float>(count);
}

// What a further sample of each pixel can take away; nothing where it may not have as many again.
TileNoise::Worth TileNoise::worth(float Pixel::*squared_error, int most_samples) const {
  Worth worth{};
  for (int row = 0; row < height_; ++row)
    for (int column = 0; column < width_; ++column) {
      const std::size_t place = place_in_tile(column, row);
      const float samples = pixels_[place].samples;
      if (2 * samples <= static_cast<float>(most_samples))
        worth[place] = mean_around(column, row, squared_error) / samples;
    }
  return worth;
}

std::bitset<tile_pixels> TileNoise::worth_doubling(float least_gain, int most_samples) const {
  return those_of(worth(&Pixel::likely_error, most_samples), least_gain);
}

std::bitset<tile_pixels> TileNoise::most_worth_doubling(int most_samples) const {
  constexpr float of_the_most = 0.25F;  // less would be more rounds for hardly fewer samples
  const Worth worth = this->worth(&Pixel::variance, most_samples);
  return those_of(worth, of_the_most * *std::max_element(worth.begin(), worth.end()));
}

}  // namespace ribbon
