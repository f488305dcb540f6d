// How near do two features come that share no vertex?
#pragma once

#include <optional>

#include "verification/box_tree.h"
#include "verification/feature_owners.h"
#include "verification/triangle_soup.h"

namespace ribbon {

// Between a feature of triangle pair.first and one of pair.second.
struct SmallestGap {
  double certain_m = 0;  // no gap of the frame is smaller; falls short of it by rounding only
  TrianglePair pair;
};

// The smallest distance between a vertex and a triangle, or an edge and an edge, that share no
// vertex, neighbours on the ribbon included; one of both is judged. The bound is rigorous
// (feature_distance.h). Says nothing about soups that intersect. Nothing when there is no such
// pair.
std::optional<SmallestGap> smallest_gap(const TriangleSoup& soup, const FeatureOwners& owners,
                                        const BoxTree& judged, const BoxTree& rest);

}  // namespace ribbon
