// A decoded frame: every coordinate as a whole number of steps (FORMAT.md, section 8.1).
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <span>

#include "geometry/ribbon_grid.h"
#include "recording/parity_planes.h"

namespace ribbon {

// Where n steps are: one product in single precision. Both factors are exact below 2^24 steps.
inline float metres(std::int32_t number, float step_m) {
  return static_cast<float>(number) * step_m;
}

// The single-precision numbers in their order, as whole numbers: neighbours differ by one.
inline std::int32_t ordered_number(float value) {
  const auto bits = std::bit_cast<std::int32_t>(value);
  return bits ^ ((bits >> 31) & 0x7FFFFFFF);
}
inline float from_ordered_number(std::int32_t number) {
  return std::bit_cast<float>(number ^ ((number >> 31) & 0x7FFFFFFF));
}

// What other frames are predicted from, unless it is plain.
struct LatticeFrame {
  RibbonGrid grid;
  float step_m = 0;                   // 0: numbers are ordered_number() of the coordinates
  PlaneFields<std::int32_t> numbers;  // by cell of ParityPlanes(grid); borders are undefined
  // The numbers themselves in single precision, metres where the step is 0. Continued over the
  // ribbon's border in straight lines.
  PlaneFields<float> values;
  bool plain = false;
  Eigen::Matrix3Xf plain_positions;  // of a plain frame, which has no numbers

  // Resized to 3 x particles, metres.
  void positions(Eigen::Matrix3Xf& positions) const;

  // Makes the values from the numbers.
  void set_values();
  // Continues the values over the border.
  void continue_values();
  [[nodiscard]] bool is_finite() const;
};

// Those of the references that can be used: all before the first plain one.
std::span<const LatticeFrame* const> usable(std::span<const LatticeFrame* const> references);

}  // namespace ribbon
