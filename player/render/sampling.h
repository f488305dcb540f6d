// Where each sample of a pixel looks: evenly spread points instead of random ones.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "player/render/ray_batch.h"

namespace ribbon {

// Independent two-dimensional patterns, one for each question that a sample asks.
enum class Pattern { pixel, sun, sky, sun_on_bounce, sky_on_bounce };
inline constexpr int pattern_count = 5;

// Sobol' sequences, Owen-scrambled and shuffled with fixed seeds, so that any first 2^k points of a
// pattern are evenly spread (B. Burley, Practical Hash-based Owen Scrambling, JCGT 9(4), 2020).
class SamplePatterns {
 public:
  // samples: the most per pixel, at least 1.
  explicit SamplePatterns(int samples);

  [[nodiscard]] int samples() const { return samples_; }
  // Point `sample` of the pattern, both coordinates in [0, 1). Keys give each pixel a pattern of
  // its own that is spread as evenly: bits are flipped, the same for all points of the pattern.
  [[nodiscard]] Eigen::Vector2f point(Pattern pattern, int sample, std::uint32_t key_x,
                                      std::uint32_t key_y) const {
    const Bits& bits = points_of(pattern)[sample];
    return {unit(bits.x ^ key_x), unit(bits.y ^ key_y)};
  }

  // Of each lane's sample the point of the pattern that belongs to the lane's pixel, any number.
  void points(Pattern pattern, const Lanes<std::uint32_t>& pixels,
              const Lanes<std::uint32_t>& samples, std::size_t count, Lanes<float>& x,
              Lanes<float>& y) const;

 private:
  struct Bits {
    std::uint32_t x;
    std::uint32_t y;
  };
  [[gnu::always_inline]] static float unit(std::uint32_t bits) {
    return static_cast<float>(static_cast<std::int32_t>(bits >> 8)) * 0x1p-24F;
  }
  [[nodiscard]] const Bits* points_of(Pattern pattern) const {
    return points_.data() + static_cast<std::size_t>(pattern) * static_cast<std::size_t>(samples_);
  }

  int samples_;
  std::vector<Bits> points_;  // pattern by pattern, all samples of each
};

// A number that looks random but depends on the argument alone.
[[gnu::always_inline]] constexpr std::uint32_t scramble(std::uint32_t x) {
  x = (x ^ (x >> 17)) * 0xED5AD4BBU;
  x = (x ^ (x >> 11)) * 0xAC4C1B51U;
  x = (x ^ (x >> 15)) * 0x31848BABU;
  return x ^ (x >> 14);
}

}  // namespace ribbon
