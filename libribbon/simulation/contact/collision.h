// Testing a pair of features for collision over one step (paper, section 5.4.1, Figures 7 and 8).
#pragma once

#include <Eigen/Core>
#include <optional>

#include "simulation/detection/feature_pairs.h"

namespace ribbon {

// A collision, in the form that the response needs: over the four vertices of the pair,
// sum(weights[k] * x_k) is the vector from the contact point of the second feature to that of the
// first, and `normal` is the unit vector along which the first lies before the second.
struct Collision {
  Eigen::Vector4d weights;
  Eigen::Vector3d normal;
};

// Do the two features collide on their straight way from `t0` to `t1`? They do
// when one passes through the other, or when they end closer than activation_m on the side on which
// they began. The instant of passing is found with the signed distance taken as linear over the
// step, so that a pair that turns far within one step may be missed.
std::optional<Collision> find_collision(const FeaturePair& pair, const VertexPositions& t0,
                                        const VertexPositions& t1, double activation_m);

}  // namespace ribbon
