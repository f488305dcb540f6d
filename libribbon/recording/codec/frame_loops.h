// The loops over all particles that decide how fast a recording is read and written. Only sums,
// differences, products and quotients, each rounded by itself and in a fixed order, and whole
// numbers modulo 2^32: every compiler and processor gets the same bits. Compiled once for each
// instruction set, so that particles lie side by side in its registers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "recording/codec/polyphase_planes.h"
#include "recording/codec/prediction_weights.h"

namespace ribbon {

// So large and no larger are quantised coordinates: single precision holds them exactly.
inline constexpr std::int32_t largest_quantised = 1 << 24;

// A frame while it is predicted, and the frames that it is predicted from; fields by cell.
struct PredictedFrame {
  const PolyphasePlanes* planes = nullptr;
  Prediction prediction = Prediction::intra;
  // False: there is no quantisation step, and a number is the ordinal of its value among all
  // single-precision values.
  bool uniform = true;
  // None of these for an intra frame. Where frames are missing others stand for them, so that the
  // differences that a prediction takes are 0.
  std::array<Triple<const float*>, 4> reference_values{};
  // One over the squared rest length between neighbours, in the unit of the values.
  float over_along_rest_squared = 0;
  float over_across_rest_squared = 0;
  const Weights* weights = nullptr;
  const IntraWeights* intra_weights = nullptr;
  // Of this frame.
  Triple<float*> values{};  // borders are not set
  Triple<float*> motion{};  // its values less those of the first frame referred to
  // Of numbers from their prediction, never negative: 0 for the number nearest to it, 1 for the
  // second nearest, ...
  Triple<std::uint32_t*> residuals{};
};

// What a stage of a prediction is fitted to, taps first, then the wanted value: sums of products of
// each with each, only those with the second not before the first. Restless particles count less.
struct NormalSums {
  // Eight sums side by side, of every eighth particle each.
  using Lanes = std::array<double, 8>;
  std::array<std::array<Lanes, most_taps + 1>, most_taps + 1> products{};
  double weight = 0;
};

// Cells side by side in a column, up to PolyphasePlanes::lane_quantum of them.
struct CellGroup {
  int plane = 0;
  std::size_t cell = 0;
  int count = 0;
};

struct FrameLoops {
  // Motion from values, with the borders that decode() gives it.
  void (*set_motion)(const PredictedFrame& frame);
  // Values and motion from residuals.
  void (*decode)(const PredictedFrame& frame);
  // Residuals from values and motion, borders closed.
  void (*encode)(const PredictedFrame& frame);
  // From values and motion, of P and B frames. unit: what change of motion is restless.
  void (*fit)(const PredictedFrame& frame, std::size_t stage, std::span<const CellGroup> groups,
              float unit, NormalSums& sums);
  // Spreads symbols of so many bits (2, 4 or 8; the first in the lowest bits of the first byte)
  // over the residuals of stretches of columns, each of which begins a byte; true where one as
  // large as `escape` is among them. Reads and writes whole vectors, up to 15 bytes and residuals
  // beyond the end.
  bool (*spread)(int bits, std::uint32_t escape, const unsigned char* symbols, std::size_t columns,
                 std::size_t length, std::size_t stride, std::uint32_t* residuals);
  // Interleaves the coordinates: positions is 3 x particles, column by column.
  void (*positions)(const PolyphasePlanes& planes, const Triple<const float*>& values, float scale,
                    float* positions);
};

// Those for instruction_set(): all give the same bits.
const FrameLoops& loops();

}  // namespace ribbon
