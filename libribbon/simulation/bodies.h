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

// The surface of the ribbon and the hierarchy over it exist only where penetrations are looked for,
// at the start and as published: they take some 600 bytes a particle, and the gate does without.
class RibbonBody {
 public:
  explicit RibbonBody(const RibbonGrid& grid) : grid_(grid) {}

  // Each is built when it is first asked for.
  const CollisionSurface& surface() {
    if (!surface_) surface_ = collision_surface(grid_.triangles());
    return *surface_;
  }
  // Over `positions` (3 x at least all particles).
  Hierarchy& hierarchy(const Eigen::Matrix3Xd& positions) {
    if (!hierarchy_) hierarchy_.emplace(surface(), positions);
    return *hierarchy_;
  }
  [[nodiscard]] bool exists() const { return surface_.has_value(); }
  void forget() {
    surface_.reset();
    hierarchy_.reset();
  }

 private:
  RibbonGrid grid_;
  std::optional<CollisionSurface> surface_;
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
