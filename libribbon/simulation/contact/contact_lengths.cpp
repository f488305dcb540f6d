#include "simulation/contact/contact_lengths.h"

#include <algorithm>
#include <numbers>

namespace ribbon {

double lost_to_rounding_m(double rounding_m) {
  return 2 * std::numbers::sqrt3 * rounding_m;
}

ContactLengths contact_lengths(double edge_m, double rounding_m, double thickness_m) {
  ContactLengths lengths;
  // Twice what rounding takes, so that half of the gap is left.
  lengths.min_separation_m =
      std::clamp(2 * lost_to_rounding_m(rounding_m), 0.05 * edge_m, 0.2 * edge_m);
  lengths.activation_m = std::max(0.2 * edge_m, 2 * lengths.min_separation_m);
  lengths.thickness_m = thickness_m;
  lengths.rounding_m = rounding_m;
  return lengths;
}

ContactLengths contact_lengths(const Scene& scene, const RestSize& size) {
  return contact_lengths(size.shortest_edge_m(),
                         scene.recording.max_position_error.value() * size.length_m,
                         scene.ribbon.thickness_m);
}

double recorded_gap_m(const ContactLengths& lengths) {
  // The gate keeps the gap in double precision: a billionth of it covers that rounding.
  return std::max(0.0,
                  (1 - 1e-9) * lengths.min_separation_m - lost_to_rounding_m(lengths.rounding_m));
}

}  // namespace ribbon
