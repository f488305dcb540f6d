// What the encoder and the decoder of positions have in common.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "geometry/ribbon_grid.h"
#include "recording/activity.h"
#include "recording/prediction.h"

namespace ribbon {

struct LatticeFrame {
  std::array<Field, 3> position;
  std::array<Field, 3> change;
  Residuals residuals;
};

// What both sides remember from frame to frame.
struct CodecMemory {
  explicit CodecMemory(const RibbonGrid& ribbon_grid)
      : ribbon(ribbon_grid), grid(ribbon_grid), activity(grid) {}

  RibbonGrid ribbon;
  PaddedGrid grid;
  double unit_m = 0;  // metres per lattice unit; 0: nothing that a delta frame could build upon
  std::array<Past, 3> past;
  Activity activity;

  void remember_key(LatticeFrame& frame);    // leaves `frame` with arbitrary content
  void remember_delta(LatticeFrame& frame);  // likewise
};

// The one place where lattice values become metres: one product and one rounding to single
// precision.
inline float metres(std::int32_t lattice_value, double unit_m) {
  return static_cast<float>(static_cast<double>(lattice_value) * unit_m);
}

// One component of a frame, from its predictor and its residuals.
template <class Residual>
void rebuild(const CodecMemory& memory, std::size_t component, const Predictor& predictor,
             Residual residual, LatticeFrame& frame) {
  Field& position = frame.position[component];
  Field& change = frame.change[component];
  if (predictor.base == PredictionBase::previous_frame)
    rebuild_from_past(memory.grid, memory.past[component], predictor, residual, position, change);
  else
    rebuild_from_rows(memory.grid, predictor, residual, position, change);
}

}  // namespace ribbon
