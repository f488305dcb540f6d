// A decoded frame: every coordinate as a whole number of steps (FORMAT.md, section 8.1).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "geometry/ribbon_grid.h"
#include "recording/codec/parity_planes.h"

namespace ribbon {

// How a frame's record holds its positions.
enum class FrameEncoding : std::uint32_t { plain = 0, lattice = 1 };

// What other frames are predicted from, unless it is plain.
struct LatticeFrame {
  RibbonGrid grid;
  float step_m = 0;  // 0: the lattice of all single-precision numbers
  // Steps, whole numbers up to largest_lattice_number in magnitude; metres where the step is 0. By
  // cell of ParityPlanes(grid), continued over the ribbon's border in straight lines.
  PlaneFields<float> values;
  bool plain = false;
  Eigen::Matrix3Xf plain_positions;  // of a plain frame, which has no values

  // Resized to 3 x particles, metres.
  void positions(Eigen::Matrix3Xf& positions) const;

  // Continues the values over the border.
  void continue_values();
  [[nodiscard]] bool is_finite() const;
};

// Those of the references that can be used: all before the first plain one.
std::span<const LatticeFrame* const> usable(std::span<const LatticeFrame* const> references);

}  // namespace ribbon
