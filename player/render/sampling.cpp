#include "player/render/sampling.h"

#include <cassert>

#include "parallel/vector_loop.h"

namespace ribbon {

namespace {

// The two first dimensions of Sobol's sequence: the bits of the index mirrored, and their running
// differences.
std::uint32_t mirrored(std::uint32_t index) {
  std::uint32_t result = 0;
  for (std::uint32_t bit = 0x80000000U; index != 0; index >>= 1, bit >>= 1)
    if ((index & 1U) != 0) result ^= bit;
  return result;
}

std::uint32_t sobol_second(std::uint32_t index) {
  std::uint32_t result = 0;
  for (std::uint32_t column = 0x80000000U; index != 0; index >>= 1, column ^= column >> 1)
    if ((index & 1U) != 0) result ^= column;
  return result;
}

// Owen's scrambling: each bit is flipped or not by a coin that belongs to the bits before it.
std::uint32_t owen_scrambled(std::uint32_t value, std::uint32_t seed) {
  std::uint32_t result = value;
  for (std::uint32_t bit = 0; bit < 32; ++bit) {
    const std::uint32_t before = bit == 0 ? 0 : value >> (32 - bit);
    if ((scramble(before + scramble(bit + scramble(seed))) & 1U) != 0) result ^= 0x80000000U >> bit;
  }
  return result;
}

}  // namespace

SamplePatterns::SamplePatterns(int samples)
    : samples_(samples), points_(pattern_count * static_cast<std::size_t>(samples)) {
  assert(samples >= 1);
  for (std::uint32_t pattern = 0; pattern < pattern_count; ++pattern) {
    const std::uint32_t seed = 10 * pattern + 1;
    for (int s = 0; s < samples; ++s) {
      // Scrambled as well, the order is another in each block of 2^k: patterns do not know each
      // other.
      const std::uint32_t index = owen_scrambled(static_cast<std::uint32_t>(s), seed);
      points_[static_cast<std::size_t>(pattern) * static_cast<std::size_t>(samples) +
              static_cast<std::size_t>(s)] = {owen_scrambled(mirrored(index), seed + 1),
                                              owen_scrambled(sobol_second(index), seed + 2)};
    }
  }
}

void SamplePatterns::points(Pattern pattern, const Lanes<std::uint32_t>& pixels,
                            const Lanes<std::uint32_t>& samples, std::size_t count, Lanes<float>& x,
                            Lanes<float>& y) const {
  const Bits* const bits = points_of(pattern);
  vectorised([&]() RIBBON_INLINED {
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t key =
          scramble(pattern_count * pixels[i] + static_cast<std::uint32_t>(pattern));
      x[i] = unit(bits[samples[i]].x ^ key);
      y[i] = unit(bits[samples[i]].y ^ scramble(key));
    }
  });
}

}  // namespace ribbon
