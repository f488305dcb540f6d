#include "player/render/sampling.h"

#include <cassert>
#include <numeric>
#include <utility>

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

// 0 ... count - 1 in an order of its own for each seed, so that patterns do not know each other.
std::vector<std::uint32_t> shuffled(int count, std::uint32_t seed) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  for (auto left = static_cast<std::uint32_t>(count); left > 1; --left)
    std::swap(order[left - 1], order[scramble(left + scramble(seed)) % left]);
  return order;
}

}  // namespace

SamplePatterns::SamplePatterns(int samples)
    : samples_(samples), points_(3 * static_cast<std::size_t>(samples)) {
  assert(samples >= 1);
  for (std::uint32_t pattern = 0; pattern < 3; ++pattern) {
    const std::uint32_t seed = 10 * pattern + 1;
    const auto order = shuffled(samples, seed);
    for (std::size_t s = 0; s < order.size(); ++s)
      points_[3 * s + pattern] = {owen_scrambled(mirrored(order[s]), seed + 1),
                                  owen_scrambled(sobol_second(order[s]), seed + 2)};
  }
}

}  // namespace ribbon
