// What can collide: the ribbon and, where the scene has one, the obstacle.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>

#include "geometry/ribbon_grid.h"
#include "simulation/detection/collision_surface.h"
#include "simulation/detection/hierarchy.h"
#include "simulation/detection/patch_tree.h"
#include "simulation/state/state_archive.h"

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
    if (!hierarchy_) build(positions.leftCols(grid_.particle_count()));
    return *hierarchy_;
  }
  [[nodiscard]] bool exists() const { return surface_.has_value(); }
  void forget() {
    surface_.reset();
    hierarchy_.reset();
    built_over_.resize(3, 0);
  }

  // How the hierarchy groups the triangles depends on where they were when it was built.
  void visit_state(StateArchive& archive) {
    auto& [grid, surface_of_grid, hierarchy_refitted_each_time, built_over] = *this;
    bool exists = hierarchy_refitted_each_time.has_value();
    archive.visit(exists);
    if (!exists) return;
    Eigen::Matrix3Xd positions = built_over;
    positions.conservativeResize(3, grid.particle_count());
    archive.visit(positions);
    if (archive.is_reading() && !archive.is_refused()) build(std::move(positions));
  }

 private:
  void build(Eigen::Matrix3Xd positions) {
    built_over_ = std::move(positions);
    hierarchy_.emplace(surface(), built_over_);
  }

  RibbonGrid grid_;
  std::optional<CollisionSurface> surface_;
  std::optional<Hierarchy> hierarchy_;
  Eigen::Matrix3Xd built_over_ = Eigen::Matrix3Xd(3, 0);
};

struct Bodies {
  Bodies(const RibbonGrid& ribbon_grid, std::optional<ObstacleBody> obstacle_body)
      : grid(ribbon_grid),
        ribbon(ribbon_grid),
        obstacle(std::move(obstacle_body)),
        patches(ribbon_grid) {}

  // The obstacle's hierarchy is the same each time; it and the patches are refitted before use.
  void visit_state(StateArchive& archive) {
    auto& [grid_of_scene, ribbon_body, obstacle_of_scene, patches_of_grid] = *this;
    ribbon_body.visit_state(archive);
  }

  RibbonGrid grid;
  RibbonBody ribbon;
  std::optional<ObstacleBody> obstacle;
  PatchTree patches;  // of the ribbon
};

}  // namespace ribbon
