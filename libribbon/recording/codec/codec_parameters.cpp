#include "recording/codec/codec_parameters.h"

#include <cmath>

namespace ribbon {

float quantisation_step_m(double max_error_m, double reach_m) {
  // Half a unit of the last digit, for the product; the step's own rounding is known to the
  // encoder, which quantises with the step as it is.
  const double left_m = max_error_m - std::ldexp(reach_m, -24);
  if (!(left_m > 0.5 * max_error_m)) return 0;
  return static_cast<float>(2 * left_m * (1 - 0x1p-20));
}

float quantisation_step_m(double max_error_m, double start_m, double length_m) {
  const float step_m = quantisation_step_m(max_error_m, start_m + length_m);
  return step_m > 0 ? step_m : quantisation_step_m(max_error_m, 1.5 * start_m);
}

}  // namespace ribbon
