// How near two features come to each other on their ways.
#pragma once

#include <Eigen/Core>

#include "simulation/detection/feature_pairs.h"

namespace ribbon {

struct ClosestApproach {
  // From the second to the first feature when they are nearest. Zero where they meet on the way, or
  // may do so for all that rounding leaves to be known.
  Eigen::Vector3d apart = Eigen::Vector3d::Zero();
  double when = 0;  // after this fraction of the displacement
};

// Of a pair of `kind`, both features taken as rigid: their relative motion is that of the points
// that are closest at the start. start, displacement: 3 x 4, the pair's corners and how far they
// are to move; weights: closest_weights() of the start.
//
// As seen from the second feature, the plane perpendicular to it separates that from all that the
// first one passes over. It lets them slide past each other, where a plane between the points that
// are closest at the start, which lie aslant, would be in the way.
ClosestApproach closest_approach(FeaturePair::Kind kind, const Eigen::Matrix<double, 3, 4>& start,
                                 const Eigen::Vector4d& weights,
                                 const Eigen::Matrix<double, 3, 4>& displacement);

}  // namespace ribbon
