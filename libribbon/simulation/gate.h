// The one gate that positions pass: no pair of features comes closer than a hard minimum gap.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "simulation/bodies.h"
#include "simulation/feature_pairs.h"

namespace ribbon {

// Moves `positions` (3 x vertices) toward `wished`, as far as it is certain that no two features
// that share no vertex come closer than min_gap_m, or, where they are closer already, any closer at
// all.
//
// Each pair that the step could bring together (swept boxes: the list is complete) gets a plane
// between its two features, perpendicular to the line between their closest points at the start.
// What room there is between features and plane is shared out in proportion to how fast each side
// approaches; a vertex that would use more than its share is shortened on its way. A vertex takes
// the shortest of its ways, and since shortening keeps it on its side of every plane, all planes
// hold at every instant of the straight motion. Motion along a contact and away from it is free.
// A pair that no plane separates, because it touches or nearly does, stays where it is.
//
// Returns how many vertices did not get all of their way.
//
// Cf. planar "divide and truncate" bounds (Chen et al. 2026) and per-vertex conservative bounds
// (Offset Geometric Contact, Chen et al. 2025).
int pass_gate(Bodies& bodies, double min_gap_m, const Eigen::Matrix3Xd& wished,
              Eigen::Matrix3Xd& positions);

// The part of its way from `start` to `wished` (3 x 4 corners of `kind`) that each of the pair's
// vertices may go, 0 ... 1, so that the gap stays above min_gap_m.
Eigen::Vector4d shares_of_way(FeaturePair::Kind kind, const Eigen::Matrix<double, 3, 4>& start,
                              const Eigen::Matrix<double, 3, 4>& way, double min_gap_m);

}  // namespace ribbon
