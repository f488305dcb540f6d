// All pairs of features that a step could bring together.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "simulation/detection/bodies.h"
#include "simulation/detection/feature_pairs.h"

namespace ribbon {

// Makes `pairs` those feature pairs, ribbon-ribbon and ribbon-obstacle, that may come within
// margin_m of each other inside the ranges of the particles, as far as boxes and flatness
// (ribbon_bvh.h) tell. Nothing is missed: a pair that is not listed stays more than margin_m apart.
void list_pairs_within_ranges(Bodies& bodies, std::span<const MovingBox> ranges, double margin_m,
                              std::vector<FeaturePair>& pairs);

// Those of them that have one of these particles, whose ranges alone differ from when
// list_pairs_within_ranges() was last called.
void list_pairs_of_changed_ranges(std::span<const int> particles, Bodies& bodies,
                                  std::span<const MovingBox> ranges,
                                  std::vector<FeaturePair>& pairs);

// As published: the pairs whose boxes over the straight way from t0 to t1 come within margin_m of
// each other, but for regions that curvature spares (TriangleBvh::Spare).
std::vector<FeaturePair> swept_pairs_by_curvature(Bodies& bodies, const Eigen::Matrix3Xd& t0,
                                                  const Eigen::Matrix3Xd& t1, double margin_m);

}  // namespace ribbon
