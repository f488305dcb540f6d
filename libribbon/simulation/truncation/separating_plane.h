// The plane between two features that keeps them apart.
#pragma once

#include <Eigen/Core>

#include "simulation/detection/feature_pairs.h"

namespace ribbon {

// The fraction of its displacement that each of the pair's vertices may go, 0 ... 1, so that the
// separation stays above min_separation_m at every instant. start, displacement: 3 x 4, the corners
// of a pair of `kind` and how far they are to move; weights: closest_weights() of the start.
//
// A plane between the two features divides the room between them in proportion to how fast each
// side approaches. A vertex that would use more than its part of the room is truncated, so each
// side stays on its side of the plane whatever becomes of the other. Motion along the plane and
// away from it is free. The plane is perpendicular to the line between their closest points, at the
// start or, where that lets them go farther, in their approach (approach.h). Features that
// are closer than min_separation_m may only part; where no plane separates them, because they touch
// or nearly do, they stay where they are.
//
// Cf. planar "divide and truncate" bounds (Chen et al. 2026).
Eigen::Vector4d displacement_fractions(FeaturePair::Kind kind,
                                       const Eigen::Matrix<double, 3, 4>& start,
                                       const Eigen::Vector4d& weights,
                                       const Eigen::Matrix<double, 3, 4>& displacement,
                                       double min_separation_m);

}  // namespace ribbon
