// What can collide: the ribbon and, where the scene has one, the obstacle.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>

#include "geometry/ribbon_grid.h"
#include "simulation/collision_surface.h"
#include "simulation/hierarchy.h"
#include "simulation/patch_tree.h"

namespace ribbon {

// A surface with the hierarchy over it.
struct Body {
  Body(CollisionSurface body_surface, const Eigen::Matrix3Xd& positions)
      : surface(std::move(body_surface)), hierarchy(surface, positions) {}

  CollisionSurface surface;
  Hierarchy hierarchy;
};

struct Bodies {
  Bodies(const RibbonGrid& ribbon_grid, Body ribbon_body, std::optional<Body> obstacle_body)
      : grid(ribbon_grid),
        ribbon(std::move(ribbon_body)),
        obstacle(std::move(obstacle_body)),
        patches(ribbon_grid) {}

  RibbonGrid grid;
  Body ribbon;
  std::optional<Body> obstacle;
  PatchTree patches;  // of the ribbon
};

}  // namespace ribbon
