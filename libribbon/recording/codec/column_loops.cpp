#include "recording/codec/column_loops.h"

#include <Eigen/Core>
#include <algorithm>
#include <limits>

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

// The negative where flip is -1; where it is 0 the number itself.
[[gnu::always_inline]] inline std::int32_t flipped(std::int32_t number, std::int32_t flip) {
  return difference_of(number ^ flip, flip);
}

// The whole number of steps that is nearest to a prediction.
struct Nearest {
  std::int32_t number;
  std::int32_t flip;  // of residuals from there: -1 where they count downwards, else 0
};

[[gnu::always_inline]] inline Nearest nearest(float steps) {
  // Single precision has no fractions between 2^23 and twice that, in whose middle this lies. A
  // prediction so far off that the sum lies elsewhere leads to another number: to the same one
  // everywhere, for it is finite.
  constexpr float whole_from = 0x1.8p23F;
  const float shifted = steps + whole_from;
  return {difference_of(Eigen::numext::bit_cast<std::int32_t>(shifted),
                        Eigen::numext::bit_cast<std::int32_t>(whole_from)),
          steps < shifted - whole_from ? 0 : -1};
}

// The ordinal of a value among all of single precision, and back.
[[gnu::always_inline]] inline std::int32_t ordinal_of(float value) {
  const auto bits = Eigen::numext::bit_cast<std::int32_t>(value);
  return bits ^ ((bits >> 31) & 0x7FFFFFFF);
}
[[gnu::always_inline]] inline float value_at(std::int32_t ordinal) {
  return Eigen::numext::bit_cast<float>(ordinal ^ ((ordinal >> 31) & 0x7FFFFFFF));
}

template <bool uniform>
[[gnu::always_inline]] inline float value_of(std::int32_t number) {
  if constexpr (!uniform) return value_at(number);
  number = number < largest_quantised ? number : largest_quantised;
  return static_cast<float>(number > -largest_quantised ? number : -largest_quantised);
}
template <bool uniform>
[[gnu::always_inline]] inline std::int32_t number_of(float value) {
  return uniform ? static_cast<std::int32_t>(value) : ordinal_of(value);
}

// The value nearest to a prediction.
[[gnu::always_inline]] inline float finite(float prediction) {
  constexpr float largest = std::numeric_limits<float>::max();
  prediction = prediction >= -largest ? prediction : 0.0F;
  return prediction <= largest ? prediction : 0.0F;
}

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

// What number a row is expected to have. reference: the value there of the first frame referred to.
template <bool uniform>
[[gnu::always_inline]] inline Nearest expected(float reference, float predicted) {
  if constexpr (!uniform) return {ordinal_of(finite(reference + predicted)), 0};
  const Nearest near = nearest(predicted);
  return {sum_of(static_cast<std::int32_t>(reference), near.number), near.flip};
}

// Makes the value of a row from its residual.
struct Decoding {
  template <bool uniform>
  [[gnu::always_inline]] static void run(const PredictedColumn& column, int row, Nearest expected) {
    const std::int32_t residual = flipped(column.residuals[row], expected.flip);
    column.values[row] = value_of<uniform>(sum_of(expected.number, residual));
  }
};

// Makes the residual of a row from its value.
struct Encoding {
  template <bool uniform>
  [[gnu::always_inline]] static void run(const PredictedColumn& column, int row, Nearest expected) {
    const std::int32_t number = number_of<uniform>(column.values[row]);
    column.residuals[row] = flipped(difference_of(number, expected.number), expected.flip);
  }
};

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
// own; in the first column what is beside is the row before. `at` is walked down; numbers are those
// of the column before, then of this one.
template <bool uniform>
void decode_intra(const PredictedColumn& at, std::int32_t* numbers) {
  std::int32_t last = 0;
  std::int32_t step = 0;
  for (int row = 0; row < at.rows; ++row) {
    step = sum_of(step, at.residuals[row]);
    last = sum_of(at.is_first ? last : numbers[row], step);
    numbers[row] = last;
  }
  vectorised([&]() RIBBON_INLINED {
    const int rows = at.rows;
    RIBBON_EACH_LANE
    for (int row = 0; row < rows; ++row) at.values[row] = value_of<uniform>(numbers[row]);
  });
}

template <bool uniform>
void encode_intra(const PredictedColumn& at, std::int32_t* numbers) {
  std::int32_t last = 0;
  std::int32_t step = 0;
  for (int row = 0; row < at.rows; ++row) {
    const std::int32_t beside = at.is_first ? last : numbers[row];
    last = number_of<uniform>(at.values[row]);
    numbers[row] = last;
    const std::int32_t next_step = difference_of(last, beside);
    at.residuals[row] = difference_of(next_step, step);
    step = next_step;
  }
}

}  // namespace

void decode(const PredictedColumn& column, const Weights& weights) {
  run<Decoding>(column, weights);
}

void encode(const PredictedColumn& column, const Weights& weights) {
  run<Encoding>(column, weights);
}

void decode_intra(const PredictedColumn& column, std::int32_t* numbers) {
  column.uniform ? decode_intra<true>(column, numbers) : decode_intra<false>(column, numbers);
}

void encode_intra(const PredictedColumn& column, std::int32_t* numbers) {
  column.uniform ? encode_intra<true>(column, numbers) : encode_intra<false>(column, numbers);
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
