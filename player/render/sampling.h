// Where each sample of a pixel looks: evenly spread points instead of random ones.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace ribbon {

// Three independent two-dimensional patterns (Sobol', Owen-scrambled with fixed seeds), one for
// each question that a sample asks.
enum class Pattern { pixel, sun, sky };

class SamplePatterns {
 public:
  // samples: how many per pixel, at least 1.
  explicit SamplePatterns(int samples);

  [[nodiscard]] int samples() const { return samples_; }
  // Point `sample` of the pattern, both coordinates in [0, 1). Keys give each pixel a pattern of
  // its own that is spread as evenly: bits are flipped, the same for all points of the pattern.
  [[nodiscard]] Eigen::Vector2f point(Pattern pattern, int sample, std::uint32_t key_x,
                                      std::uint32_t key_y) const {
    const auto& bits = points_[static_cast<std::size_t>(sample) * 3 + static_cast<int>(pattern)];
    return {unit(bits.x ^ key_x), unit(bits.y ^ key_y)};
  }

 private:
  struct Bits {
    std::uint32_t x;
    std::uint32_t y;
  };
  static float unit(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24F; }

  int samples_;
  std::vector<Bits> points_;  // sample by sample, three patterns each
};

// A number that looks random but depends on the argument alone.
constexpr std::uint32_t scramble(std::uint32_t x) {
  x = (x ^ (x >> 17)) * 0xED5AD4BBU;
  x = (x ^ (x >> 11)) * 0xAC4C1B51U;
  x = (x ^ (x >> 15)) * 0x31848BABU;
  return x ^ (x >> 14);
}

}  // namespace ribbon
