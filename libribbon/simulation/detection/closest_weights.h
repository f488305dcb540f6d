// The closest points of a pair of features.
#pragma once

#include <Eigen/Core>

#include "simulation/detection/feature_pairs.h"

namespace ribbon {

// Weights of the pair's four vertices such that corners * weights is the vector from the closest
// point of the second feature to that of the first. corners: 3 x 4 positions, in the pair's order.
Eigen::Vector4d closest_weights(FeaturePair::Kind kind, const Eigen::Matrix<double, 3, 4>& corners);

}  // namespace ribbon
