// What the encoder and the decoder of positions must agree upon; it stands in the header.
#pragma once

#include <string>
#include <vector>

#include "geometry/ribbon_grid.h"

namespace ribbon {

struct CodecParameters {
  RibbonGrid grid;
  // Positions lie on a lattice through the world's origin: n steps are the coordinate
  // f32(f64(n) * step_m), n from -2^30 to 2^30. 0: the lattice of all single-precision numbers.
  double step_m = 0;
  std::vector<std::string> entropy_tables;  // zstd dictionaries
};

// The step of the coarsest lattice that keeps every coordinate up to `reach_m` in magnitude within
// max_error_m of the truth, rounding to single precision included. 0, the lattice of all
// single-precision numbers, where that rounding alone takes half of the bound, and for a bound of
// 0.
double lattice_step_m(double max_error_m, double reach_m);

}  // namespace ribbon
