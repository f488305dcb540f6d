// While there is a collision: update velocity and displacement (paper, section 5.4).
#pragma once

#include <Eigen/Core>
#include <span>

#include "simulation/cloth.h"
#include "simulation/feature_pairs.h"

namespace ribbon {

struct ContactSettings {
  double gap_m = 0;          // colliding features are moved this far apart
  double restitution = 0.1;  // 0 ... 1; small, for stability (section 5.4.2)
  int rounds = 10;           // of detection and repulsion, at most
};

// Repels once each of `pairs` that collides on its straight way from `before` (3 x vertices) to the
// cloth's present positions. Was there one?
bool repel_once(std::span<const FeaturePair> pairs, const ContactSettings& settings,
                const Eigen::Matrix3Xd& before, Cloth& cloth);

}  // namespace ribbon
