// The innermost loop of the simulation: with what springs pull.
#pragma once

#include <array>
#include <cstddef>

namespace ribbon {

// `count` springs one after the other, each array as long. No two arrays
// overlap but `starts` with `ends`.
struct SpringRun {
  std::ptrdiff_t count = 0;
  const double* stiffness = nullptr;  // N/m
  double rest_length_m = 0;  // of each, where there is no list; not used where the stiffness is 0
  const double* rest_lengths_m = nullptr;  // of one after the other, finite
  std::array<const double*, 3> starts{};   // the coordinates of their starts and ends, m
  std::array<const double*, 3> ends{};
  std::array<double*, 3> tension{};  // result: the force on the start, N
  // Result: stiffness times elongation squared; not computed where there is no list.
  double* twice_energy_j = nullptr;
};

// Fills in the results. Uses the widest registers that the processor has; each spring is computed
// by itself in the same operations, so that the bits are the same with any.
void compute_tension(const SpringRun& run);

}  // namespace ribbon
