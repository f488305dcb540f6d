#include "simulation/contact/gap_lengths.h"

#include <algorithm>
#include <numbers>

namespace ribbon {

double lost_to_rounding_m(double rounding_m) {
  return 2 * std::numbers::sqrt3 * rounding_m;
}

GapLengths gap_lengths(double edge_m, double rounding_m, double thickness_m) {
  GapLengths lengths;
  // Twice what rounding takes, so that half of the gap is left.
  lengths.hard_m = std::clamp(2 * lost_to_rounding_m(rounding_m), 0.05 * edge_m, 0.2 * edge_m);
  lengths.contact_m = std::max(0.2 * edge_m, 2 * lengths.hard_m);
  lengths.thickness_m = thickness_m;
  return lengths;
}

double recorded_gap_m(const GapLengths& lengths, double rounding_m) {
  // The gate keeps the gap in double precision: a billionth of it covers that rounding.
  return std::max(0.0, (1 - 1e-9) * lengths.hard_m - lost_to_rounding_m(rounding_m));
}

}  // namespace ribbon
