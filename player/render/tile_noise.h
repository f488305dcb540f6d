// How noisy a tile still is, and where more samples help most.
#pragma once

#include <Eigen/Core>
#include <array>
#include <bitset>
#include <cstddef>

namespace ribbon {

inline constexpr int tile_side = 16;  // pixels
inline constexpr int tile_pixels = tile_side * tile_side;

// Of a pixel among those of its tile.
constexpr std::size_t place_in_tile(int column, int row) {
  return static_cast<std::size_t>(row) * tile_side + static_cast<std::size_t>(column);
}

// Samples are spread so evenly that their mean is far better than that of independent ones: what
// they say about it by how much they differ is useless. But the first and the second half of them
// are as evenly spread, each, so the means of both tell by how much they differ. Half of that
// difference has 2^(2p) - 1 times the variance of the mean of all, where errors fall as
// samples^-p: 1 for independent samples, 1.5 for ours (p is about 2/3). The factor is kept as a
// reserve for what no sample has found.
class TileNoise {
 public:
  // A tile of which so many columns and rows lie in the picture; no samples yet.
  void begin(int width, int height);
  // Some pixels have their first samples, or twice as many as before: sums over all samples of each
  // pixel, of their light, whose fourth number counts them, and of its luminance's square.
  void update(const std::array<Eigen::Array4f, tile_pixels>& light,
              const std::array<float, tile_pixels>& squared_light);

  // Estimated error of the tile, in 8-bit levels: root of the mean square over its pixels. Wants
  // every pixel to have been updated twice.
  [[nodiscard]] float error() const;
  // The pixels where each further sample takes at least `least_gain` squared levels from the
  // squared error, but for those that have so many that twice of them are more than `most_samples`.
  [[nodiscard]] std::bitset<tile_pixels> worth_doubling(float least_gain, int most_samples) const;
  // Those where it takes most.
  [[nodiscard]] std::bitset<tile_pixels> most_worth_doubling(int most_samples) const;

 private:
  using Numbers = std::array<float, tile_pixels>;  // of the pixels; zero outside the picture
  [[nodiscard]] Numbers worth(const Numbers& squared_error, int most_samples) const;

  int width_ = 0;
  int height_ = 0;
  Numbers samples_{};
  Numbers mean_{};
  Numbers squared_error_{};  // by the halves of its samples
  Numbers variance_{};       // of the mean, if samples were independent
  Numbers likely_error_{};   // squared, by both
};

}  // namespace ribbon
