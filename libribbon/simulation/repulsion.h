// Adding repulsions (paper, section 5.4.2).
#pragma once

#include "simulation/cloth.h"
#include "simulation/collision.h"

namespace ribbon {

// Moves the colliding pair apart until the contact points are gap_m apart along the normal, and
// gives its vertices new velocities if they approach: after the collision they part with
// `restitution` (0 ... 1) times the speed at which they met. Both changes conserve momentum; the
// obstacle's vertices, of boundless mass, stay.
void repel(const FeaturePair& pair, const Collision& collision, double gap_m, double restitution,
           Cloth& cloth);

}  // namespace ribbon
