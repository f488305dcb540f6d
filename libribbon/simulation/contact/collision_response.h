// Update velocity and displacement of what collides (paper, section 5.4).
#pragma once

#include <Eigen/Core>
#include <span>

#include "simulation/contact/pair_gaps.h"
#include "simulation/contact/repulsion.h"
#include "simulation/detection/feature_pairs.h"
#include "simulation/state/cloth.h"

namespace ribbon {

// Repels once each of `pairs` that collides on its straight way from `before` (3 x vertices) to the
// cloth's present positions, or ends closer than contact begins. Was there one?
bool repel_once(std::span<const FeaturePair> pairs, const PairGaps& gaps,
                const RepulsionSettings& settings, const Eigen::Matrix3Xd& before, Cloth& cloth);

}  // namespace ribbon
