// How near two features come to each other on their ways.
#pragma once

#include <Eigen/Core>

#include "simulation/detection/feature_pairs.h"

namespace ribbon {

struct Approach {
  // From the closest point of the second feature to that of the first.
  Eigen::Vector3d apart = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 3, 4> corners = Eigen::Matrix<double, 3, 4>::Zero();  // where they are then
};

// Of a pair of `kind`, both features taken as rigid: their relative motion is that of the points
// that are closest at the start. When they are nearest, or, if they come nearer than that, when
// they are first down to near_m (> 0), within a hundredth of it; the start where they are so near
// there. start, displacement: 3 x 4, the pair's corners and how far they are to move; weights:
// closest_weights() of the start, at which they do not meet.
//
// As seen from the second feature, the plane perpendicular to `apart` separates that from all that
// the first one passes over until then. It lets them slide past each other, where a plane between
// the points that are closest at the start, which lie aslant, would be in the way.
Approach approach_down_to(double near_m, FeaturePair::Kind kind,
                          const Eigen::Matrix<double, 3, 4>& start, const Eigen::Vector4d& weights,
                          const Eigen::Matrix<double, 3, 4>& displacement);

}  // namespace ribbon
