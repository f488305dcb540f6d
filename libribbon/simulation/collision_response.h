// While there is a collision: update velocity and displacement (paper, section 5.4).
#pragma once

#include <Eigen/Core>

#include "simulation/bodies.h"
#include "simulation/cloth.h"

namespace ribbon {

struct ContactSettings {
  double gap_m = 0;          // colliding features are moved this far apart
  double restitution = 0.1;  // 0 ... 1; small, for stability (section 5.4.2)
  int rounds = 10;           // of detection and repulsion, at most
};

// Repels all features that collide on their straight way from `before` (3 x vertices) to the
// cloth's present positions, again and again until none does or the rounds are used up.
void repel_collisions(Bodies& bodies, const ContactSettings& settings, Hierarchy::Spare spare,
                      const Eigen::Matrix3Xd& before, Cloth& cloth);

}  // namespace ribbon
