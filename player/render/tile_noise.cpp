#include "player/render/tile_noise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "parallel/vector_loop.h"
#include "player/render/lane_vector.h"

namespace ribbon {

namespace {

// Of light, in squared 8-bit levels where the picture shows `mean`; sRGB is near enough to a square
// root here.
[[gnu::always_inline]] inline float in_levels(float square, float mean) {
  constexpr float darkest = 0.002F;
  return 127.5F * 127.5F * square / (mean < darkest ? darkest : mean);
}

// How many of a row of `count` lie beside one or are it.
int neighbours(int number, int count) {
  return std::min(number + 1, count - 1) - std::max(number - 1, 0) + 1;
}

std::bitset<tile_pixels> those_of(const std::array<float, tile_pixels>& worth, float least) {
  constexpr std::size_t word_bits = 64;
  std::bitset<tile_pixels> pixels;
  for (std::size_t end = tile_pixels; end > 0; end -= word_bits) {
    std::uint64_t word = 0;
    for (std::size_t bit = 0; bit < word_bits; ++bit) {
      const float of_pixel = worth[end - word_bits + bit];
      word |= static_cast<std::uint64_t>(of_pixel > 0 && of_pixel >= least) << bit;
    }
    pixels = pixels << word_bits | std::bitset<tile_pixels>(word);
  }
  return pixels;
}

}  // namespace

void TileNoise::begin(int width, int height) {
  width_ = width;
  height_ = height;
  for (Numbers* numbers : {&samples_, &mean_, &squared_error_, &variance_, &likely_error_})
    numbers->fill(0);
}

void TileNoise::update(const std::array<Eigen::Array4f, tile_pixels>& light,
                       const std::array<float, tile_pixels>& squared_light) {
  // The halves tell more, but that those of few samples agree may be chance.
  constexpr float trust_in_halves = 0.8F;
  const float* const numbers = light.front().data();
  vectorised([&]() RIBBON_INLINED {
    RIBBON_EACH_LANE
    for (std::size_t place = 0; place < tile_pixels; ++place) {
      const float samples = numbers[4 * place + 3];
      const float mean =
          luminance({numbers[4 * place], numbers[4 * place + 1], numbers[4 * place + 2]}) / samples;
      const float half_difference = mean - mean_[place];
      const float squared_error = in_levels(half_difference * half_difference, mean);
      const float spread = squared_light[place] / samples - mean * mean;
      const float variance =
          in_levels((spread < 0 ? 0 : spread) / (samples < 2 ? 1 : samples - 1), mean);
      const float likely_error = trust_in_halves * squared_error + (1 - trust_in_halves) * variance;
      const bool has_more = samples != samples_[place];
      samples_[place] = samples;
      mean_[place] = has_more ? mean : mean_[place];
      squared_error_[place] = has_more ? squared_error : squared_error_[place];
      variance_[place] = has_more ? variance : variance_[place];
      likely_error_[place] = has_more ? likely_error : likely_error_[place];
    }
  });
}

float TileNoise::error() const {
  float sum = 0;
  for (const float squared_error : squared_error_) sum += squared_error;
  return std::sqrt(sum / static_cast<float>(width_ * height_));
}

// What a further sample of each pixel can take away; nothing where it may not have as many again.
// A pixel whose samples agree may have missed what its neighbours found: so the mean of those
// around it counts.
TileNoise::Numbers TileNoise::worth(const Numbers& squared_error, int most_samples) const {
  constexpr std::size_t side = tile_side;
  constexpr std::size_t pitch = side + 2;
  std::array<float, pitch * pitch> bordered{};  // by zeros
  for (std::size_t row = 0; row < side; ++row)
    std::copy_n(squared_error.begin() + static_cast<std::ptrdiff_t>(row * side), side,
                bordered.begin() + static_cast<std::ptrdiff_t>((row + 1) * pitch + 1));
  std::array<float, side> columns{};  // of those around one pixel
  for (int column = 0; column < tile_side; ++column)
    columns[static_cast<std::size_t>(column)] = static_cast<float>(neighbours(column, width_));
  Numbers worth{};
  const auto most = static_cast<float>(most_samples);
  vectorised([&]() RIBBON_INLINED {
    for (int row = 0; row < height_; ++row) {
      const auto rows = static_cast<float>(neighbours(row, height_));
      const float* const above = &bordered[static_cast<std::size_t>(row) * pitch];
      const float* const beside = above + pitch;
      const float* const below = beside + pitch;
      const float* const samples = &samples_[place_in_tile(0, row)];
      float* const of_row = &worth[place_in_tile(0, row)];
      RIBBON_EACH_LANE
      RIBBON_EACH_LANE_OF_A_FEW
      for (std::size_t c = 0; c < side; ++c) {
        const float sum = above[c] + above[c + 1] + above[c + 2] + beside[c] + beside[c + 1] +
                          beside[c + 2] + below[c] + below[c + 1] + below[c + 2];
        const float gain = sum / (rows * columns[c]) / samples[c];
        const float doubled = samples[c] > 0 ? 2 * samples[c] : most + 1;
        of_row[c] = doubled <= most ? gain : 0.0F;
      }
    }
  });
  return worth;
}

std::bitset<tile_pixels> TileNoise::worth_doubling(float least_gain, int most_samples) const {
  return those_of(worth(likely_error_, most_samples), least_gain);
}

std::bitset<tile_pixels> TileNoise::most_worth_doubling(int most_samples) const {
  constexpr float of_the_most = 0.25F;  // less would be more rounds for hardly fewer samples
  const Numbers worth = this->worth(variance_, most_samples);
  return those_of(worth, of_the_most * *std::max_element(worth.begin(), worth.end()));
}

}  // namespace ribbon
