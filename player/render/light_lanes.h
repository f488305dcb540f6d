// Light that arrives at surfaces, many at a time.
#pragma once

#include "player/render/lighting.h"
#include "player/render/ray_batch.h"

namespace ribbon {

// The first `count` lanes become zero.
void clear(VectorLanes& lanes, std::size_t count);

void add_to(VectorLanes& lanes, std::size_t lane, const Color& light);

// Adds to each of `count` lanes its share of the light of the sky in the lane's direction.
void add_sky_shares(const Lighting& lighting, const Lanes<float>& shares,
                    const VectorLanes& directions, std::size_t count, VectorLanes& lanes);

// Adds what white cloth shows under the open sky, for unit normals.
void add_mean_sky(const Lighting& lighting, const VectorLanes& normals, std::size_t count,
                  VectorLanes& lanes);

}  // namespace ribbon
