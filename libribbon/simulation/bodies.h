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
struct ObstacleBody {
  ObstacleBody(CollisionSurface body_surface, const Eigen::Matrix3Xd& positions)
      : surface(std::move(body_surface)), hierarchy(surface, positions) {}

  CollisionSurface surface;
  Hierarchy hierarchy;
};

// The hierarchy over the ribbon exists only where the published method or its schemes detect: it
// takes some 500 bytes a particle, and the gate does without.
class RibbonBody {
 public:
  explicit RibbonBody(const RibbonGrid& grid) : surface(collision_surface(grid.triangles())) {}

  // Built when it is first asked for, over `positions` (3 x at least all particles).
  Hierarchy& hierarchy(const Eigen::Matrix3Xd& positions) {
    if (!hierarchy_) hierarchy_.emplace(surface, positions);
    return *hierarchy_;
  }
  void forget_hierarchy() { hierarchy_.reset(); }
  [[nodiscard]] bool has_hierarchy() const { return hierarchy_.has_value(); }

  CollisionSurface surface;

 private:
  std::optional<Hierarchy> hierarchy_;
};

struct Bodies {
  Bodies(const RibbonGrid& ribbon_grid, std::optional<ObstacleBody> obstacle_body)
      : grid(ribbon_grid),
        ribbon(ribbon_grid),
        obstacle(std::move(obstacle_body)),
        patches(ribbon_grid) {}

  RibbonGrid grid;
  RibbonBody ribbon;
  std::optional<ObstacleBody> obstacle;
  PatchTree patches;  // of the ribbon
};

}  // namespace ribbon
