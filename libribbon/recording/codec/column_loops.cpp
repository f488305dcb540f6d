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
  // Single precision has no fractions between this and twice a third more.
  constexpr float whole_from = 0x1.8p23F;
  constexpr float largest = 0x1p22F;
  steps = steps > -largest ? steps : -largest;  // what is no number, too
  steps = steps < largest ? steps : largest;
  const float shifted = steps + whole_from;
  return {Eigen::numext::bit_cast<std::int32_t>(shifted) -
              Eigen::numext::bit_cast<std::int32_t>(whole_from),
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
[[gnu::always_inline]] inline std::int32_t ordinal_of_prediction(float value) {
  constexpr float largest = std::numeric_limits<float>::max();
  value = value >= -largest ? value : 0.0F;
  value = value <= largest ? value : 0.0F;
  return ordinal_of(value);
}

[[gnu::always_inline]] inline float in_exact_range(std::int32_t number) {
  number = number < largest_quantised ? number : largest_quantised;
  number = number > -largest_quantised ? number : -largest_quantised;
  return static_cast<float>(number);
}

// Makes values from residuals.
struct Decoding {
  template <bool uniform>
  [[gnu::always_inline]] static void run(const PredictedColumn& column, int row, float reference,
                                         float predicted) {
    const std::uint32_t residual = column.residuals[row];
    float value = 0;
    if constexpr (uniform) {
      const Nearest near = nearest(predicted);
      value = in_exact_range(sum_of(sum_of(static_cast<std::int32_t>(reference), near.number),
                                    offset_of(residual, near.below)));
    } else {
      value =
          value_at(sum_of(ordinal_of_prediction(reference + predicted), offset_of(residual, 0)));
    }
    column.values[row] = value;
    column.motion[row] = value - reference;
  }
};

// Makes residuals from values.
struct Encoding {
  template <bool uniform>
  [[gnu::always_inline]] static void run(const PredictedColumn& column, int row, float reference,
                                         float predicted) {
    const float value = column.values[row];
    if constexpr (uniform) {
      const Nearest near = nearest(predicted);
      const std::int32_t expected = sum_of(static_cast<std::int32_t>(reference), near.number);
      column.residuals[row] =
          residual_of(difference_of(static_cast<std::int32_t>(value), expected), near.below);
    } else {
      column.residuals[row] = residual_of(
          difference_of(ordinal_of(value), ordinal_of_prediction(reference + predicted)), 0);
    }
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

  // Of the neighbours on both sides.
  [[gnu::always_inline]] static float pair(Floats field, std::ptrdiff_t at, std::ptrdiff_t step) {
    return field[at - step] + field[at + step];
  }
  // How far the middle between two neighbours is away, twice.
  [[gnu::always_inline]] [[nodiscard]] float bend(std::ptrdiff_t at, std::ptrdiff_t step) const {
    return pair(values, at, step) - (values[at] + values[at]);
  }

  [[gnu::always_inline]] [[nodiscard]] float from_past(const std::array<float, past_taps>& w,
                                                       std::ptrdiff_t at) const {
    const float line = (w[0] * motion[at] + w[1] * motion[at - 1]) + w[2] * motion[at + 1];
    const float sides = w[3] * motion[at - stride] + w[4] * motion[at + stride];
    const float before =
        (w[5] * older[at] + w[6] * pair(older, at, 1)) + w[7] * pair(older, at, stride);
    const float shape = w[8] * bend(at, 1) + w[9] * bend(at, stride);
    return (line + sides) + (before + shape);
  }
  [[gnu::always_inline]] [[nodiscard]] float from_beside(const std::array<float, near_taps>& w,
                                                         std::ptrdiff_t at) const {
    return (w[0] * beside[at - 1] + w[1] * beside[at]) + w[2] * beside[at + 1];
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
      Work::template run<uniform>(at, row, around.values[row], predicted);
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

// From the rows before and the column before.
template <bool is_first>
[[gnu::always_inline]] inline float intra_prediction(const PredictedColumn& column, int row,
                                                     float curvature) {
  const Floats x = column.values + row;
  if constexpr (is_first) return row == 0 ? 0 : row == 1 ? x[-1] : (x[-1] + x[-1]) - x[-2];
  const float beside = x[-column.stride];
  if (row == 0) return beside;
  const float step = x[-1] - x[-1 - column.stride];
  if (row == 1) return beside + step;
  return (beside + step) + curvature * (step - (x[-2] - x[-2 - column.stride]));
}

template <class Work, bool uniform, bool is_first>
void run_intra(const Triple<PredictedColumn>& columns, float curvature) {
  const Triple<PredictedColumn> at = columns;
  for (int row = 0; row < at[0].rows; ++row)
    for (const PredictedColumn& column : at)
      Work::template run<uniform>(column, row, 0,
                                  intra_prediction<is_first>(column, row, curvature));
}

template <class Work>
void run_intra(const Triple<PredictedColumn>& columns, float curvature) {
  if (columns[0].uniform)
    columns[0].is_first ? run_intra<Work, true, true>(columns, curvature)
                        : run_intra<Work, true, false>(columns, curvature);
  else
    columns[0].is_first ? run_intra<Work, false, true>(columns, curvature)
                        : run_intra<Work, false, false>(columns, curvature);
}

}  // namespace

void decode(const PredictedColumn& column, const Weights& weights) {
  run<Decoding>(column, weights);
}

void encode(const PredictedColumn& column, const Weights& weights) {
  run<Encoding>(column, weights);
}

void decode_intra(const Triple<PredictedColumn>& columns, float curvature) {
  run_intra<Decoding>(columns, curvature);
}

void encode_intra(const Triple<PredictedColumn>& columns, float curvature) {
  run_intra<Encoding>(columns, curvature);
}

void set_taps(const PredictedColumn& column, int first_row, Taps& taps) {
  vectorised([&]() RIBBON_INLINED {
    const Neighbourhood around(column);
    const auto pair = Neighbourhood::pair;
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
                                              pair(around.older, at, 1),
                                              pair(around.older, at, around.stride),
                                              around.bend(at, 1),
                                              around.bend(at, around.stride)};
      for (std::size_t tap = 0; tap < past_taps; ++tap) taps[tap][k] = past[tap];
      for (std::size_t tap = 0; tap < near_taps && !column.is_first; ++tap)
        taps[past_taps + tap][k] = around.beside[at - 1 + static_cast<std::ptrdiff_t>(tap)];
      taps[most_taps][k] = column.motion[at];
    }
  });
}

}  // namespace ribbon
