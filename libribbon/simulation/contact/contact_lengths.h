// The lengths at which contact works.
#pragma once

#include "geometry/rest_size.h"
#include "scene/scene.h"

namespace ribbon {

struct ContactLengths {
  double min_separation_m = 0;  // no two features come closer than this
  double activation_m = 0;      // closer features are moved apart
  double thickness_m = 0;       // of the cloth; 0: none
  double rounding_m = 0;        // by which recording may move each coordinate
};

// What rounding may take from, or add to, the distance of two points: it moves each by at most
// sqrt 3 roundings of a coordinate.
double lost_to_rounding_m(double rounding_m);

// The lengths for a ribbon whose shortest rest edge is edge_m (> 0) and whose recording may move
// each coordinate by rounding_m (>= 0). Neighbours in the flat ribbon must not count as too close,
// so the minimum separation is at most a fifth of an edge, however coarse the rounding.
ContactLengths contact_lengths(double edge_m, double rounding_m, double thickness_m);
// Those of a band of that size, in a scene that has a max_position_error.
ContactLengths contact_lengths(const Scene& scene, const RestSize& size);

// The smallest gap that is left in a recording whatever the rounding did; 0 where it may take all.
double recorded_gap_m(const ContactLengths& lengths);

}  // namespace ribbon
