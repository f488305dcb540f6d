#include "recording/codec_parameters.h"

#include <cmath>

namespace ribbon {

double lattice_step_m(double max_error_m, double reach_m) {
  const double left_m = max_error_m - std::ldexp(reach_m, -24);
  return left_m > 0.5 * max_error_m ? 2 * left_m : 0;
}

}  // namespace ribbon
