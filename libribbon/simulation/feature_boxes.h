// Boxes of the features of a surface.
#pragma once

#include <span>
#include <vector>

#include "geometry/box.h"
#include "simulation/collision_surface.h"

namespace ribbon {

// The boxes of a surface's edges and triangles over the ranges of their vertices (one for each
// vertex that the surface uses).
struct FeatureBoxes {
  std::vector<MovingBox> edges;
  std::vector<MovingBox> triangles;

  void refit(const CollisionSurface& surface, std::span<const MovingBox> ranges);
};

}  // namespace ribbon
