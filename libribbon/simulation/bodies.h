// What can collide: the ribbon and, where the scene has one, the obstacle.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/ribbon_grid.h"
#include "simulation/collision_surface.h"
#include "simulation/hierarchy.h"

namespace ribbon {

// A surface with the hierarchy over it.
struct Body {
  Body(CollisionSurface body_surface, const Eigen::Matrix3Xd& positions)
      : surface(std::move(body_surface)), hierarchy(surface, positions) {}

  CollisionSurface surface;
  Hierarchy hierarchy;
};

struct Bodies {
  RibbonGrid grid;
  Body ribbon;
  std::optional<Body> obstacle;
};

}  // namespace ribbon
