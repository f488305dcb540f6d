// Adding repulsions (paper, section 5.4.2).
#pragma once

#include "simulation/contact/collision.h"
#include "simulation/state/cloth.h"

namespace ribbon {

struct RepulsionSettings {
  double restitution = 0.1;  // 0 ... 1; small, for stability
  double friction = 0;       // Coulomb's coefficient, >= 0; the paper has none
};

// Moves the colliding pair apart until the contact points are gap_m apart along the normal, and
// gives its vertices new velocities if they approach: after the collision they part with
// `restitution` times the speed at which they met. With friction, what the contact points have slid
// over each other since `before` (3 x vertices) and the speed at which they slide are reduced by at
// most `friction` times the change along the normal. All changes conserve momentum; the obstacle's
// vertices, of boundless mass, stay.
void repel(const FeaturePair& pair, const Collision& collision, double gap_m,
           const RepulsionSettings& settings, const Eigen::Matrix3Xd& before, Cloth& cloth);

}  // namespace ribbon
