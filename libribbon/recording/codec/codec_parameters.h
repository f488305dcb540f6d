// What the encoder and the decoder of positions must agree upon; it stands in the header.
#pragma once

#include "geometry/ribbon_grid.h"

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
float quantisation_step_m(double max_error_m, double reach_m);

// Likewise for a ribbon that starts with coordinates up to `start_m`: it can be drawn its length
// further. Where rounding so far away takes too much of the bound, half as far again as the start
// must do: frames that go beyond are plain.
float quantisation_step_m(double max_error_m, double start_m, double length_m);

}  // namespace ribbon
