// The weights of a prediction (FORMAT.md, section 8.4).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace ribbon {

// A particle is predicted from its past, that is the frames referred to, and from neighbours in the
// column before, whose motion is known by then.
inline constexpr std::size_t past_taps = 7;
inline constexpr std::size_t near_taps = 3;
inline constexpr std::size_t most_taps = past_taps + near_taps;

struct Weights {
  std::array<float, past_taps> past{};
  std::array<float, near_taps> near{};
};

// Weights as they are recorded, whole numbers of 2^-shift: those of the first column, which has
// none before it, and those of all others.
struct RecordedWeights {
  int shift = 0;
  std::array<std::int32_t, past_taps> first{};
  std::array<std::int32_t, most_taps> others{};  // past, then near

  // Visits them in their order: visit(number).
  template <class Visit>
  void for_each(Visit visit) {
    for (std::int32_t& number : first) visit(number);
    for (std::int32_t& number : others) visit(number);
  }

  [[nodiscard]] Weights of_first_column() const;
  [[nodiscard]] Weights of_others() const;
};

}  // namespace ribbon
