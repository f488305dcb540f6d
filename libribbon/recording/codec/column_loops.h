// The loops over a column of particles that decide how fast a recording is read and written. Only
// sums, differences and products, each rounded by itself and in a fixed order, and whole numbers
// modulo 2^32: every compiler and processor gets the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "recording/codec/particle_columns.h"

namespace ribbon {

// So large and no larger are quantised coordinates: single precision holds them exactly.
inline constexpr std::int32_t largest_quantised = 1 << 24;

// What a particle is predicted from (FORMAT.md, section 8.4): motion around it and the bend of the
// ribbon there in the reference, then motion in the column before, which is known by then.
inline constexpr std::size_t past_taps = 6;
inline constexpr std::size_t most_taps = past_taps + 3;
using Weights = std::array<float, most_taps>;

// A column of a component while it is predicted. Pointers are to its first particle; neighbours in
// other columns are `stride` away.
struct PredictedColumn {
  int rows = 0;
  std::ptrdiff_t stride = 0;
  bool is_first = false;
  // False: there is no quantisation step, and a number is the ordinal of its value among all
  // single-precision values.
  bool uniform = true;
  // Of the reference; none of an intra frame.
  const float* past_values = nullptr;
  const float* past_motion = nullptr;
  float* values = nullptr;  // of this frame
  float* motion = nullptr;  // its values less past_values; left alone in an intra frame
  // Of numbers from their prediction: 0 for the number nearest to it, -1 for the second nearest, 1
  // for the third, ...
  std::int32_t* residuals = nullptr;
};

// Values and motion from residuals, which are used up, or residuals and motion from values. Of an
// intra frame the value before the first is overwritten; it has no weights.
void decode(const PredictedColumn& column, const Weights& weights);
void encode(const PredictedColumn& column, const Weights& weights);

// What the weights are applied to, in their order, then the motion that they should add up to: of
// sixteen rows side by side, 0 beyond the column's end. Not of an intra frame.
inline constexpr int tap_rows = 16;
using Taps = std::array<std::array<float, tap_rows>, most_taps + 1>;
void set_taps(const PredictedColumn& column, int first_row, Taps& taps);

}  // namespace ribbon
