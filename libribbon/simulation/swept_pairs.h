// All pairs of features that a step could bring together.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "simulation/bodies.h"
#include "simulation/feature_pairs.h"

namespace ribbon {

// The feature pairs, ribbon-ribbon and ribbon-obstacle, whose boxes over the ranges of their
// vertices come within margin_m of each other. Nothing is missed: a pair that is not listed stays
// more than margin_m apart in some coordinate while each of its vertices is anywhere in its range.
std::vector<FeaturePair> pairs_within_ranges(Bodies& bodies, std::span<const Box> ranges,
                                             double margin_m);

// As published: the pairs whose boxes over the straight way from t0 to t1 come within margin_m of
// each other, but for regions that curvature spares (Hierarchy::Spare).
std::vector<FeaturePair> swept_pairs_by_curvature(Bodies& bodies, const Eigen::Matrix3Xd& t0,
                                                  const Eigen::Matrix3Xd& t1, double margin_m);

}  // namespace ribbon
