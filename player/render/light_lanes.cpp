#include "player/render/light_lanes.h"

#include <algorithm>

#include "parallel/vector_loop.h"
#include "player/render/lane_vector.h"

namespace ribbon {

namespace {

// light(i, below, rise): what lane i gets of a sky that changes evenly from `below` by `rise`.
template <class Light>
void add_gradient(const Lighting& lighting, std::size_t count, VectorLanes& lanes,
                  const Light& light) {
  const LaneVector below = lane_vector(lighting.sky_below);
  const LaneVector rise = lane_vector(lighting.sky_above - lighting.sky_below);
  vectorised([&]() RIBBON_INLINED {
    const std::size_t end = filled_up(count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i)
      set_lane(lanes, i, lane_of(lanes, i) + light(i, below, rise));
  });
}

}  // namespace

void clear(VectorLanes& lanes, std::size_t count) {
  for (Lanes<float>* lane : {&lanes.x, &lanes.y, &lanes.z}) std::fill_n(lane->begin(), count, 0.0F);
}

void add_to(VectorLanes& lanes, std::size_t lane, const Color& light) {
  lanes.x[lane] += light[0];
  lanes.y[lane] += light[1];
  lanes.z[lane] += light[2];
}

void add_sky_shares(const Lighting& lighting, const Lanes<float>& shares,
                    const VectorLanes& directions, std::size_t count, VectorLanes& lanes) {
  if (lighting.environment) {
    for (std::size_t i = 0; i < count; ++i)
      if (shares[i] != 0) add_to(lanes, i, lighting.sky(directions.at(i)) * shares[i]);
    return;
  }
  add_gradient(lighting, count, lanes,
               [&](std::size_t i, const LaneVector& below, const LaneVector& rise) RIBBON_INLINED {
                 return shares[i] * (below + (0.5F + directions.y[i] / 2) * rise);
               });
}

void add_mean_sky(const Lighting& lighting, const VectorLanes& normals, std::size_t count,
                  VectorLanes& lanes) {
  if (lighting.environment) {
    for (std::size_t i = 0; i < count; ++i) add_to(lanes, i, lighting.mean_sky(normals.at(i)));
    return;
  }
  add_gradient(lighting, count, lanes,
               [&](std::size_t i, const LaneVector& below, const LaneVector& rise)
                   RIBBON_INLINED { return below + (0.5F + normals.y[i] / 3) * rise; });
}

}  // namespace ribbon
