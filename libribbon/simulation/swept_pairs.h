// All pairs of features that a step could bring together.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "simulation/bodies.h"
#include "simulation/feature_pairs.h"

namespace ribbon {

// The feature pairs, ribbon-ribbon and ribbon-obstacle, whose boxes over the way from t0 to t1 come
// within margin_m of each other. With Spare::boxes nothing is missed: a pair that is not listed
// stays more than margin_m apart in some coordinate while each vertex is anywhere on its straight
// way.
std::vector<FeaturePair> swept_pairs(Bodies& bodies, Hierarchy::Spare spare,
                                     const Eigen::Matrix3Xd& t0, const Eigen::Matrix3Xd& t1,
                                     double margin_m);

}  // namespace ribbon
