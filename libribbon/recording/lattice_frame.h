// A decoded frame: every coordinate as a whole number of steps (FORMAT.md, section 8.1).
#pragma once

#include <Eigen/Core>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// The single-precision numbers in their order, as whole numbers: neighbours differ by one.
inline std::int32_t ordered_number(float value) {
  const auto bits = std::bit_cast<std::int32_t>(value);
  return bits ^ ((bits >> 31) & 0x7FFFFFFF);
}
inline float from_ordered_number(std::int32_t number) {
  return std::bit_cast<float>(number ^ ((number >> 31) & 0x7FFFFFFF));
}

// Other frames are predicted from it, unless it is plain.
struct LatticeFrame {
  RibbonGrid grid;
  double step_m = 0;  // 0: numbers are ordered_number() of the coordinates
  std::array<std::vector<std::int32_t>, 3> numbers;  // x, y, z; by particle
  bool plain = false;
  Eigen::Matrix3Xf plain_positions;  // of a plain frame, which has no numbers

  // Resized to 3 x particles, metres.
  void positions(Eigen::Matrix3Xf& positions) const;
};

// Where n steps are: one product in double precision and one rounding to single precision.
inline float metres(std::int32_t number, double step_m) {
  return static_cast<float>(static_cast<double>(number) * step_m);
}

}  // namespace ribbon
