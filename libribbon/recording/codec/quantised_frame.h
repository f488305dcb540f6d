// A decoded frame: quantised positions, every coordinate a whole number of steps (FORMAT.md,
// section 8.1).
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "geometry/ribbon_grid.h"
#include "recording/codec/particle_columns.h"

namespace ribbon {

// How a frame's record holds its positions: in single precision, or in quantisation steps.
enum class FrameEncoding : std::uint8_t { exact = 0, quantised = 1 };

// What another one may be predicted from.
struct QuantisedFrame {
  RibbonGrid grid;
  float step_m = 0;  // 0: exact single precision
  // Steps, whole numbers up to largest_quantised in magnitude; metres where the step is 0. By cell
  // of ParticleColumns(grid), continued over the ends of columns in straight lines; nothing is said
  // beside the first and the last column.
  CellValues values;
  // Likewise, continued there as well: values less those of the frame that it was predicted from; 0
  // for an intra frame.
  CellValues motion;

  // Resized to 3 x particles, metres.
  void positions(Eigen::Matrix3Xf& positions) const;
};

// The reference, unless it is rounded otherwise than the frame: then it is no help.
inline const QuantisedFrame* usable(const QuantisedFrame* reference, const QuantisedFrame& frame) {
  return reference != nullptr && reference->step_m == frame.step_m ? reference : nullptr;
}

}  // namespace ribbon
