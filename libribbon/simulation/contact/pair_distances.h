// How close the two features of a pair may come.
#pragma once

#include <algorithm>
#include <functional>
#include <utility>

#include "geometry/rest_size.h"
#include "simulation/contact/contact_lengths.h"
#include "simulation/detection/feature_pairs.h"

namespace ribbon {

// How close pairs have to come to matter: as of_pair says, where there is such a function, and
// never more than largest_m.
struct PairReach {
  double largest_m = 0;
  std::function<double(const FeaturePair&)> of_pair = nullptr;
};

// A pair's minimum separation, and the activation distance, at which contact begins. Cloth with
// thickness touches itself at its thickness and the obstacle at half of it, and gives way to at
// most half of that; features that lie close in the flat ribbon, as neighbours do, count as
// touching at half of that distance at most.
class PairDistances {
 public:
  PairDistances(RestSize size, const ContactLengths& lengths);

  [[nodiscard]] double min_separation_m(const FeaturePair& pair) const {
    return is_thick() ? std::max(lengths_.min_separation_m, 0.5 * thick_activation_m(pair))
                      : lengths_.min_separation_m;
  }
  [[nodiscard]] double activation_m(const FeaturePair& pair) const {
    return is_thick() ? std::max(lengths_.activation_m, thick_activation_m(pair))
                      : lengths_.activation_m;
  }
  // The largest of each over all pairs.
  [[nodiscard]] double largest_min_separation_m() const {
    return std::max(lengths_.min_separation_m, 0.5 * lengths_.thickness_m);
  }
  [[nodiscard]] double largest_activation_m() const {
    return std::max(lengths_.activation_m, lengths_.thickness_m);
  }

  // The activation distance and `beyond_m`; `times` the minimum separation. Not to outlive this.
  [[nodiscard]] PairReach activation_reach(double beyond_m) const;
  [[nodiscard]] PairReach min_separation_reach(double times) const;

 private:
  [[nodiscard]] bool is_thick() const { return lengths_.thickness_m > 0; }
  [[nodiscard]] double thick_activation_m(const FeaturePair& pair) const;
  [[nodiscard]] double rest_distance_m(const FeaturePair& pair) const;
  [[nodiscard]] double distance_across_m(const FeaturePair& pair) const;

  RestSize size_;
  ContactLengths lengths_;
  double corner_to_diagonal_m_;  // of the smallest quad
  int numbers_apart_when_far_;
};

}  // namespace ribbon
