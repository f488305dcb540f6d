// Updating velocity and displacement of what collides (paper, section 5.4.2).
#pragma once

#include <Eigen/Core>
#include <span>

#include "simulation/contact/collision.h"
#include "simulation/contact/pair_distances.h"
#include "simulation/detection/bodies.h"
#include "simulation/state/cloth.h"

namespace ribbon {

// Moves the colliding pair apart until the contact points are activation_m apart along the normal,
// and gives its particles new velocities if they approach: after the collision they part with
// a tenth of the speed at which they met. With friction (friction.h), what the contact
// points have slid over each other since `before` and the speed at which they slide are reduced;
// `friction` is Coulomb's coefficient, >= 0; the paper has none.
// All changes conserve momentum. `now`: the cloth's present positions and the obstacle's vertices,
// which are boundlessly heavy (paper, section 5.1) and stay.
void repel(const FeaturePair& pair, const Collision& collision, double activation_m,
           double friction, const VertexPositions& before, const VertexPositions& now,
           Cloth& cloth);

// Repels once each of `pairs` that collides on its straight way from `before` (3 x particles) to
// the cloth's present positions, or ends closer than contact begins. Was there one?
bool repel_once(std::span<const FeaturePair> pairs, const PairDistances& distances, double friction,
                const Bodies& bodies, const Eigen::Matrix3Xd& before, Cloth& cloth);

}  // namespace ribbon
