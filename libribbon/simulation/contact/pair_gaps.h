// How close the two features of a pair may come.
#pragma once

#include <algorithm>

#include "ribbon_mesh/rest_size.h"
#include "simulation/contact/gap_lengths.h"
#include "simulation/detection/feature_pairs.h"

namespace ribbon {

// A pair's hard gap, and the distance at which contact begins. Cloth with thickness touches itself
// at its thickness and the obstacle at half of it, and gives way to at most half of that; features
// that lie close in the flat ribbon, as neighbours do, count as touching at half of that distance
// at most.
class PairGaps {
 public:
  PairGaps(const RestSize& size, const GapLengths& lengths) : size_(size), lengths_(lengths) {}

  [[nodiscard]] double hard_m(const FeaturePair& pair) const {
    return is_thick() ? std::max(lengths_.hard_m, 0.5 * thick_contact_m(pair)) : lengths_.hard_m;
  }
  [[nodiscard]] double contact_m(const FeaturePair& pair) const {
    return is_thick() ? std::max(lengths_.contact_m, thick_contact_m(pair)) : lengths_.contact_m;
  }
  // The largest of each over all pairs.
  [[nodiscard]] double largest_hard_m() const {
    return std::max(lengths_.hard_m, 0.5 * lengths_.thickness_m);
  }
  [[nodiscard]] double largest_contact_m() const {
    return std::max(lengths_.contact_m, lengths_.thickness_m);
  }

 private:
  [[nodiscard]] bool is_thick() const { return lengths_.thickness_m > 0; }
  [[nodiscard]] double thick_contact_m(const FeaturePair& pair) const;
  [[nodiscard]] double natural_distance_m(const FeaturePair& pair) const;

  RestSize size_;
  GapLengths lengths_;
};

}  // namespace ribbon
