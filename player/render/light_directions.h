// Directions towards the light, many at a time.
#pragma once

#include <Eigen/Core>

#include "player/render/ray_batch.h"

namespace ribbon {

// The points of the unit disc that `u` and `v` in [0, 1) stand for: what is evenly spread stays so.
// No functions of the C library, so that pixels do not depend on it. `count` of each.
void to_disc(const Lanes<float>& u, const Lanes<float>& v, std::size_t count, Lanes<float>& x,
             Lanes<float>& y);

// Towards a sun whose middle lies in the unit direction `middle`, and whose disc has `radius` as
// the tangent of half its angle: one direction of unit length for each point of the unit disc.
void to_sun(const Eigen::Vector3f& middle, float radius, const Lanes<float>& disc_x,
            const Lanes<float>& disc_y, std::size_t count, VectorLanes& direction);

// About unit normals, as likely as the cosine between them: one for each point of the unit disc.
void to_sky(const VectorLanes& normal, const Lanes<float>& disc_x, const Lanes<float>& disc_y,
            std::size_t count, VectorLanes& direction);

// Scalar products.
void products(const VectorLanes& a, const VectorLanes& b, std::size_t count, Lanes<float>& result);

}  // namespace ribbon
