#include "recording/codec/column_loops.h"

#include <Eigen/Core>
#include <algorithm>
#include <limits>

#include "parallel/vector_loop.h"

namespace ribbon {

namespace {

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

// The bits of a value as its ordinal among all of single precision, and back.
[[gnu::always_inline]] inline std::int32_t ordered(std::int32_t bits) {
  return bits ^ ((bits >> 31) & 0x7FFFFFFF);
}

template <bool uniform>
[[gnu::always_inline]] inline float value_of(std::int32_t number) {
  constexpr std::int32_t largest = uniform ? largest_quantised : 0x7F7FFFFF;
  constexpr std::int32_t least = uniform ? -largest : ~largest;
  number = number < largest ? number : largest;
  number = number > least ? number : least;
  return uniform ? static_cast<float>(number) : Eigen::numext::bit_cast<float>(ordered(number));
}
template <bool uniform>
[[gnu::always_inline]] inline std::int32_t number_of(float value) {
  return uniform ? static_cast<std::int32_t>(value)
                 : ordered(Eigen::numext::bit_cast<std::int32_t>(value));
}

// What number a row is expected to have.
struct Expected {
  std::int32_t number;
  std::int32_t flip;  // of residuals from there: -1 where they count downwards, else 0
};

// past: the value there of the reference.
template <bool uniform>
[[gnu::always_inline]] inline Expected expected(float past, float motion) {
  if constexpr (!uniform) {
    constexpr float largest = std::numeric_limits<float>::max();
    float value = past + motion;
    value = value >= -largest ? value : 0.0F;
    value = value <= largest ? value : 0.0F;
    return {number_of<false>(value), 0};
  }
  // Single precision has no fractions between 2^23 and twice that, in whose middle this lies. A
  // prediction so far off that the sum lies elsewhere leads to another number: to the same one
  // everywhere, for it is finite.
  constexpr float whole_from = 0x1.8p23F;
  const float shifted = motion + whole_from;
  const std::int32_t steps = difference_of(Eigen::numext::bit_cast<std::int32_t>(shifted),
                                           Eigen::numext::bit_cast<std::int32_t>(whole_from));
  return {sum_of(number_of<true>(past), steps), motion < shifted - whole_from ? 0 : -1};
}

// How far the middle between the neighbours of a row along the ribbon is away, twice.
[[gnu::always_inline]] inline float bend(const float* values, std::ptrdiff_t row) {
  return (values[row - 1] + values[row + 1]) - (values[row] + values[row]);
}

[[gnu::always_inline]] inline float predicted_motion(const PredictedColumn& column,
                                                     const Weights& w, std::ptrdiff_t row) {
  const float* m = column.past_motion + row;
  const float* q = column.motion + row - column.stride;
  const float line = (w[0] * m[0] + w[1] * m[-1]) + w[2] * m[1];
  const float sides = w[3] * m[-column.stride] + w[4] * m[column.stride];
  const float near = (w[6] * q[-1] + w[7] * q[0]) + w[8] * q[1];
  return ((line + sides) + w[5] * bend(column.past_values, row)) + near;
}

// The number that a row of an intra frame is expected to be as far away from as the row before is
// from its own: that of the row beside it, of the row before in the first column.
const float* beside(const PredictedColumn& column) {
  if (!column.is_first) return column.values - column.stride;
  column.values[-1] = 0;
  return column.values - 1;
}

// Makes values from residuals.
struct Decoding {
  template <bool uniform>
  [[gnu::always_inline]] static void run(const PredictedColumn& column, int row,
                                         Expected expected) {
    const std::int32_t residual = flipped(column.residuals[row], expected.flip);
    column.values[row] = value_of<uniform>(sum_of(expected.number, residual));
  }

  template <bool uniform>
  static void run_intra(const PredictedColumn& column) {
    std::int32_t distance = 0;
    for (int row = 0; row < column.rows; ++row)
      column.residuals[row] = distance = sum_of(distance, column.residuals[row]);
    const float* from = beside(column);
    const PredictedColumn to = column;
    const auto place = [=](int row) RIBBON_INLINED {
      to.values[row] = value_of<uniform>(sum_of(number_of<uniform>(from[row]), to.residuals[row]));
    };
    if (column.is_first) {
      for (int row = 0; row < to.rows; ++row) place(row);
      return;
    }
    vectorised([&]() RIBBON_INLINED {
      RIBBON_EACH_LANE
      for (int row = 0; row < to.rows; ++row) place(row);
    });
  }
};

// Makes residuals from values.
struct Encoding {
  template <bool uniform>
  [[gnu::always_inline]] static void run(const PredictedColumn& column, int row,
                                         Expected expected) {
    const std::int32_t number = number_of<uniform>(column.values[row]);
    column.residuals[row] = flipped(difference_of(number, expected.number), expected.flip);
  }

  template <bool uniform>
  static void run_intra(const PredictedColumn& column) {
    const float* from = beside(column);
    std::int32_t last = 0;
    for (int row = 0; row < column.rows; ++row) {
      const std::int32_t distance =
          difference_of(number_of<uniform>(column.values[row]), number_of<uniform>(from[row]));
      column.residuals[row] = difference_of(distance, last);
      last = distance;
    }
  }
};

template <class Work, bool uniform>
void run(const PredictedColumn& column, const Weights& weights) {
  if (column.past_values == nullptr) return Work::template run_intra<uniform>(column);
  vectorised([&]() RIBBON_INLINED {
    const Weights w = weights;
    const PredictedColumn at = column;
    RIBBON_EACH_LANE
    for (int row = 0; row < at.rows; ++row) {
      const float past = at.past_values[row];
      Work::template run<uniform>(at, row, expected<uniform>(past, predicted_motion(at, w, row)));
      at.motion[row] = at.values[row] - past;
    }
  });
}

}  // namespace

void decode(const PredictedColumn& column, const Weights& weights) {
  column.uniform ? run<Decoding, true>(column, weights) : run<Decoding, false>(column, weights);
}

void encode(const PredictedColumn& column, const Weights& weights) {
  column.uniform ? run<Encoding, true>(column, weights) : run<Encoding, false>(column, weights);
}

void set_taps(const PredictedColumn& column, int first_row, Taps& taps) {
  const int rows = std::min(tap_rows, column.rows - first_row);
  if (rows < tap_rows) taps = {};
  const std::ptrdiff_t side = column.stride;
  vectorised([&]() RIBBON_INLINED {
    auto lanes = taps.begin();
    const auto set = [&](auto at) RIBBON_INLINED {
      RIBBON_EACH_LANE
      for (int k = 0; k < rows; ++k) (*lanes)[k] = at(std::ptrdiff_t{first_row} + k);
      ++lanes;
    };
    const float* m = column.past_motion;
    for (const std::ptrdiff_t away : std::array<std::ptrdiff_t, 5>{0, -1, 1, -side, side})
      set([=](std::ptrdiff_t row) RIBBON_INLINED { return m[row + away]; });
    const float* past = column.past_values;
    const float* now = column.values;
    set([=](std::ptrdiff_t row) RIBBON_INLINED { return bend(past, row); });
    for (const std::ptrdiff_t away : {-side - 1, -side, -side + 1, std::ptrdiff_t{0}})
      set([=](std::ptrdiff_t row) RIBBON_INLINED { return now[row + away] - past[row + away]; });
  });
}

}  // namespace ribbon
