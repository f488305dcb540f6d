// What the encoder and the decoder of positions must agree upon; it stands in the header.
#pragma once

#include "geometry/ribbon_grid.h"
#include "geometry/single_precision.h"

namespace ribbon {

struct CodecParameters {
  RibbonGrid grid;
  // The quantisation step: number n stands for the coordinate n * step_m in single precision. 0:
  // coordinates are kept exactly, in single precision.
  float step_m = 0;

  bool operator==(const CodecParameters&) const = default;
};

// The largest step that keeps every coordinate up to `reach_m` in magnitude within max_error_m of
// the truth, rounding to single precision included. 0 (exact single precision) where that rounding
// takes half of the bound, and for a bound of 0.
inline float quantisation_step_m(double max_error_m, double reach_m) {
  // That of the product; the step's own rounding is known to the encoder, which quantises with the
  // step as it is.
  const double left_m = max_error_m - largest_rounding(reach_m);
  if (!(left_m > 0.5 * max_error_m)) return 0;
  return static_cast<float>(2 * left_m * (1 - 0x1p-20));
}

// Likewise for a ribbon that starts with coordinates up to `start_m`: it can be drawn its length
// further. Where rounding so far away takes too much of the bound, half as far again as the start
// must do: frames that go beyond are exact.
inline float quantisation_step_m(double max_error_m, double start_m, double length_m) {
  const float step_m = quantisation_step_m(max_error_m, start_m + length_m);
  return step_m > 0 ? step_m : quantisation_step_m(max_error_m, 1.5 * start_m);
}

}  // namespace ribbon
