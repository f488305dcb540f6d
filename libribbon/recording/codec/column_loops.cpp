#include "recording/codec/column_loops.h"

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <type_traits>

#include "parallel/vector_loop.h"

namespace ribbon {

namespace {

using Floats = const float*;

// In whole numbers modulo 2^32.
[[gnu::always_inline]] inline std::int32_t sum_of(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}
[[gnu::always_inline]] inline std::int32_t difference_of(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}

// Residuals 1, 3, 5, ... are 1, 2, 3, ... away on the nearer side, 2, 4, ... on the other. below:
// -1 where the nearer side is below, else 0.
[[gnu::always_inline]] inline std::int32_t offset_of(std::uint32_t residual, std::int32_t below) {
  const auto half = static_cast<std::int32_t>((residual >> 1U) + (residual & 1U));
  const std::int32_t flip = (static_cast<std::int32_t>(residual & 1U) - 1) ^ below;
  return difference_of(half ^ flip, flip);
}

[[gnu::always_inline]] inline std::uint32_t residual_of(std::int32_t offset, std::int32_t below) {
  const std::int32_t other_side = difference_of(below, offset ^ below);
  return static_cast<std::uint32_t>(sum_of(other_side, other_side) ^ (other_side >> 31));
}

// A prediction as a whole number of steps, and on which side of it the second nearest number is:
// -1 below, else 0.
struct Nearest {
  std::int32_t number;
  std::int32_t below;
};

[[gnu::always_inline]] inline Nearest nearest(float steps) {
  // Single precision has no fractions between 2^23 and twice that, in whose middle this lies. A
  // prediction so far off that the sum lies elsewhere leads to another number: to the same one
  // everywhere, for it is finite.
  constexpr float whole_from = 0x1.8p23F;
  const float shifted = steps + whole_from;
  return {difference_of(Eigen::numext::bit_cast<std::int32_t>(shifted),
                        Eigen::numext::bit_cast<std::int32_t>(whole_from)),
          steps < shifted - whole_from ? -1 : 0};
}

// The ordinal of a value among all of single precision, and back.
[[gnu::always_inline]] inline std::int32_t ordinal_of(float value) {
  const auto bits = Eigen::numext::bit_cast<std::int32_t>(value);
  return bits ^ ((bits >> 31) & 0x7FFFFFFF);
}
[[gnu::always_inline]] inline float value_at(std::int32_t ordinal) {
  return Eigen::numext::bit_cast<float>(ordinal ^ ((ordinal >> 31) & 0x7FFFFFFF));
}

[[gnu::always_inline]] inline std::int32_t in_exact_range(std::int32_t number) {
  number = number < largest_quantised ? number : largest_quantised;
  return number > -largest_quantised ? number : -largest_quantised;
}

// What a number stands for in sums: itself, or the value whose ordinal it is.
template <bool uniform>
using Meaning = std::conditional_t<uniform, std::int32_t, float>;

template <bool uniform>
[[gnu::always_inline]] inline Meaning<uniform> meaning_of(std::int32_t number) {
  if constexpr (uniform)
    return number;
  else
    return value_at(number);
}
// The number that is nearest to a prediction.
[[gnu::always_inline]] inline std::int32_t number_for(std::int32_t prediction) {
  return prediction;
}
[[gnu::always_inline]] inline std::int32_t number_for(float prediction) {
  constexpr float largest = std::numeric_limits<float>::max();
  prediction = prediction >= -largest ? prediction : 0.0F;
  prediction = prediction <= largest ? prediction : 0.0F;
  return ordinal_of(prediction);
}

// Makes the value of a row from its residual; returns its number.
struct Decoding {
  template <bool uniform>
  [[gnu::always_inline]] static std::int32_t run(const PredictedColumn& column, int row,
                                                 Nearest expected) {
    std::int32_t number = sum_of(expected.number, offset_of(column.residuals[row], expected.below));
    if constexpr (uniform) number = in_exact_range(number);
    column.values[row] = static_cast<float>(meaning_of<uniform>(number));
    return number;
  }
};

// Makes the residual of a row from its value; returns its number.
struct Encoding {
  template <bool uniform>
  [[gnu::always_inline]] static std::int32_t run(const PredictedColumn& column, int row,
                                                 Nearest expected) {
    const float value = column.values[row];
    const std::int32_t number = uniform ? static_cast<std::int32_t>(value) : ordinal_of(value);
    column.residuals[row] = residual_of(difference_of(number, expected.number), expected.below);
    return number;
  }
};

// What a row is predicted from. at: the row, as an offset.
struct Neighbourhood {
  Floats values, motion, older, beside;
  std::ptrdiff_t stride;

  explicit Neighbourhood(const PredictedColumn& column)
      : values(column.past_values),
        motion(column.past_motion),
        older(column.older_motion),
        beside(column.motion - column.stride),
        stride(column.stride) {}

  // How far the middle between the neighbours along the ribbon is away, twice.
  [[gnu::always_inline]] [[nodiscard]] float bend(std::ptrdiff_t at) const {
    return (values[at - 1] + values[at + 1]) - (values[at] + values[at]);
  }

  [[gnu::always_inline]] [[nodiscard]] float from_past(const std::array<float, past_taps>& w,
                                                       std::ptrdiff_t at) const {
    const float line = (w[0] * motion[at] + w[1] * motion[at - 1]) + w[2] * motion[at + 1];
    const float sides = w[3] * motion[at - stride] + w[4] * motion[at + stride];
    return (line + sides) + (w[5] * older[at] + w[6] * bend(at));
  }
  [[gnu::always_inline]] [[nodiscard]] float from_beside(const std::array<float, near_taps>& w,
                                                         std::ptrdiff_t at) const {
    return (w[0] * beside[at - 1] + w[1] * beside[at]) + w[2] * beside[at + 1];
  }
};

// reference: the value there of the first frame referred to.
template <bool uniform>
[[gnu::always_inline]] inline Nearest expected(float reference, float predicted) {
  if constexpr (uniform) {
    const Nearest near = nearest(predicted);
    return {sum_of(static_cast<std::int32_t>(reference), near.number), near.below};
  } else {
    return {number_for(reference + predicted), 0};
  }
}

template <class Work, bool uniform, bool is_first>
void run(const PredictedColumn& column, const Weights& weights) {
  vectorised([&]() RIBBON_INLINED {
    const Neighbourhood around(column);
    const Weights w = weights;
    const PredictedColumn at = column;
    RIBBON_EACH_LANE
    for (int row = 0; row < at.rows; ++row) {
      float predicted = around.from_past(w.past, row);
      if constexpr (!is_first) predicted += around.from_beside(w.near, row);
      Work::template run<uniform>(at, row, expected<uniform>(around.values[row], predicted));
      at.motion[row] = at.values[row] - around.values[row];
    }
  });
}

template <class Work>
void run(const PredictedColumn& column, const Weights& weights) {
  if (column.uniform)
    column.is_first ? run<Work, true, true>(column, weights)
                    : run<Work, true, false>(column, weights);
  else
    column.is_first ? run<Work, false, true>(column, weights)
                    : run<Work, false, false>(column, weights);
}

// Every row lies as far from the one beside it, in the column before, as the row before from its
// own; in the first column what is beside is the row before.
template <class Work, bool uniform, bool is_first>
void run_intra(const Triple<PredictedColumn>& columns) {
  const Triple<PredictedColumn> at = columns;
  Triple<Meaning<uniform>> last{};
  Triple<Meaning<uniform>> step{};  // of the row before
  for (int row = 0; row < at[0].rows; ++row)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto beside =
          is_first ? last[c] : static_cast<Meaning<uniform>>(at[c].values[row - at[c].stride]);
      const Nearest expected{number_for(beside + step[c]), 0};
      last[c] = meaning_of<uniform>(Work::template run<uniform>(at[c], row, expected));
      step[c] = last[c] - beside;
    }
}

template <class Work>
void run_intra(const Triple<PredictedColumn>& columns) {
  if (columns[0].uniform)
    columns[0].is_first ? run_intra<Work, true, true>(columns)
                        : run_intra<Work, true, false>(columns);
  else
    columns[0].is_first ? run_intra<Work, false, true>(columns)
                        : run_intra<Work, false, false>(columns);
}

}  // namespace

void decode(const PredictedColumn& column, const Weights& weights) {
  run<Decoding>(column, weights);
}

void encode(const PredictedColumn& column, const Weights& weights) {
  run<Encoding>(column, weights);
}

void decode_intra(const Triple<PredictedColumn>& columns) {
  run_intra<Decoding>(columns);
}

void encode_intra(const Triple<PredictedColumn>& columns) {
  run_intra<Encoding>(columns);
}

void set_taps(const PredictedColumn& column, int first_row, Taps& taps) {
  vectorised([&]() RIBBON_INLINED {
    const Neighbourhood around(column);
    const int rows = std::min(tap_rows, column.rows - first_row);
    for (auto& tap : taps) tap.fill(0);
    for (int k = 0; k < rows; ++k) {
      const std::ptrdiff_t at = first_row + k;
      const std::array<float, past_taps> past{around.motion[at],
                                              around.motion[at - 1],
                                              around.motion[at + 1],
                                              around.motion[at - around.stride],
                                              around.motion[at + around.stride],
                                              around.older[at],
                                              around.bend(at)};
      for (std::size_t tap = 0; tap < past_taps; ++tap) taps[tap][k] = past[tap];
      for (std::size_t tap = 0; tap < near_taps && !column.is_first; ++tap)
        taps[past_taps + tap][k] = around.beside[at - 1 + static_cast<std::ptrdiff_t>(tap)];
      taps[most_taps][k] = column.motion[at];
    }
  });
}

}  // namespace ribbon
