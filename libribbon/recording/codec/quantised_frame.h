// A decoded frame: quantised positions, every coordinate a whole number of steps (FORMAT.md,
// section 8.1).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "geometry/ribbon_grid.h"
#include "recording/codec/particle_columns.h"

namespace ribbon {

// How a frame's record holds its positions.
enum class FrameEncoding : std::uint32_t { plain = 0, quantised = 1 };

// What other frames are predicted from, unless it is plain.
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
  bool plain = false;
  Eigen::Matrix3Xf plain_positions;  // of a plain frame, which has no values

  // Resized to 3 x particles, metres.
  void positions(Eigen::Matrix3Xf& positions) const;

  [[nodiscard]] bool is_finite() const;
};

// Those of the references that can be used: all before the first plain one.
std::span<const QuantisedFrame* const> usable(std::span<const QuantisedFrame* const> references);

}  // namespace ribbon
