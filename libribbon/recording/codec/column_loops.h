// The loops over a column of particles that decide how fast a recording is read and written. Only
// sums, differences and products, each rounded by itself and in a fixed order, and whole numbers
// modulo 2^32: every compiler and processor gets the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "recording/codec/particle_columns.h"
#include "recording/codec/prediction_weights.h"

namespace ribbon {

// So large and no larger are quantised coordinates: single precision holds them exactly.
inline constexpr std::int32_t largest_quantised = 1 << 24;

// A column of a component while it is predicted. Pointers are to its first particle; neighbours in
// other columns are `stride` away.
struct PredictedColumn {
  int rows = 0;
  std::ptrdiff_t stride = 0;
  bool is_first = false;  // there is no column before it
  // False: there is no quantisation step, and a number is the ordinal of its value among all
  // single-precision values.
  bool uniform = true;
  // Values of the first frame referred to, its motion and that of the second; none for an intra
  // frame.
  const float* past_values = nullptr;
  const float* past_motion = nullptr;
  const float* older_motion = nullptr;
  float* values = nullptr;  // of this frame
  float* motion = nullptr;  // its values less past_values
  // Of numbers from their prediction: 0 for the number nearest to it, -1 for the second nearest, 1
  // for the third, ...
  std::int32_t* residuals = nullptr;
};

// Values and motion from residuals, or residuals from values; predicted from references.
void decode(const PredictedColumn& column, const Weights& weights);
void encode(const PredictedColumn& column, const Weights& weights);

// Likewise without references, from the column before. Motion is left as it is. numbers: of a whole
// column, those of the column before, unless it is the first; then those of this one.
void decode_intra(const PredictedColumn& column, std::int32_t* numbers);
void encode_intra(const PredictedColumn& column, std::int32_t* numbers);

// What the weights are applied to, in their order, past before near, then the motion that they
// should add up to: of sixteen rows side by side, 0 beyond the column's end.
inline constexpr int tap_rows = 16;
using Taps = std::array<std::array<float, tap_rows>, most_taps + 1>;
void set_taps(const PredictedColumn& column, int first_row, Taps& taps);

}  // namespace ribbon
