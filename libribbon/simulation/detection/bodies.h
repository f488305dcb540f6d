// What can collide: the ribbon and, where the scene has one, the obstacle.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "geometry/ribbon_grid.h"
#include "simulation/detection/collision_surface.h"
#include "simulation/detection/ribbon_bvh.h"
#include "simulation/detection/triangle_bvh.h"
#include "simulation/detection/triangle_fans.h"
#include "simulation/detection/vertex_positions.h"
#include "simulation/state/state_archive.h"

namespace ribbon {

// The object with the bounding volume hierarchy (BVH) over its surface. It never moves.
struct ObstacleBody {
  // 3 x triangles, 3 x vertices.
  ObstacleBody(Eigen::Matrix3Xi triangles, Eigen::Matrix3Xd body_vertices)
      : vertices(std::move(body_vertices)),
        surface(collision_surface(with_equal_vertices_joined(std::move(triangles), vertices))),
        fans(surface.triangles, vertices.cols()),
        bvh(surface, vertices) {}

  Eigen::Matrix3Xd vertices;
  CollisionSurface surface;
  TriangleFans fans;
  TriangleBvh bvh;
};

// The surface of the ribbon and the BVH over it exist only where penetrations are looked for,
// at the start and as published: they are large, and the gate does without.
class RibbonBody {
 public:
  explicit RibbonBody(const RibbonGrid& grid) : grid_(grid) {}

  // Each is built when it is first asked for.
  const CollisionSurface& surface() {
    if (!surface_) surface_ = collision_surface(grid_.triangles());
    return *surface_;
  }
  // Over `positions` (3 x particles).
  TriangleBvh& triangle_bvh(const Eigen::Matrix3Xd& positions) {
    if (!bvh_) build(positions);
    return *bvh_;
  }
  void forget() {
    surface_.reset();
    bvh_.reset();
    built_over_.resize(3, 0);
  }

  // How the BVH groups the triangles depends on where they were when it was built.
  void visit_state(StateArchive& archive) {
    auto& [grid, surface_of_grid, bvh_refitted_each_time, built_over] = *this;
    bool exists = bvh_refitted_each_time.has_value();
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
    bvh_.emplace(surface(), built_over_);
  }

  RibbonGrid grid_;
  std::optional<CollisionSurface> surface_;
  std::optional<TriangleBvh> bvh_;
  Eigen::Matrix3Xd built_over_ = Eigen::Matrix3Xd(3, 0);
};

struct Bodies {
  Bodies(const RibbonGrid& ribbon_grid, std::optional<ObstacleBody> obstacle_body)
      : grid(ribbon_grid),
        ribbon(ribbon_grid),
        obstacle(std::move(obstacle_body)),
        ribbon_bvh(ribbon_grid) {}

  // All vertices that features have, with the particles where they are given (3 x particles).
  [[nodiscard]] VertexPositions vertices(const Eigen::Matrix3Xd& particles) const {
    return obstacle ? VertexPositions(particles, obstacle->vertices) : VertexPositions(particles);
  }
  // The others are the obstacle's.
  [[nodiscard]] bool is_particle(int vertex) const { return vertex < grid.particle_count(); }

  // As RibbonGrid has it, for vertices of either; of the obstacle's as far as TriangleFans has
  // them.
  template <class IsFound>
  [[nodiscard]] bool any_triangle_at(int vertex, const IsFound& is_found) const {
    if (is_particle(vertex)) return grid.any_triangle_at(vertex, is_found);
    const int first = grid.particle_count();
    const auto fan = obstacle->fans.of(vertex - first);
    return std::any_of(fan.begin(), fan.end(), [&](const TriangleFans::Corners& others) {
      return is_found(first + others[0], first + others[1]);
    });
  }

  // The corner of an edge with fewer triangles, and the other one.
  [[nodiscard]] std::array<int, 2> smaller_fan_first(int a, int b) const {
    if (is_particle(a)) return {a, b};
    const int first = grid.particle_count();
    const bool in_order =
        obstacle->fans.of(a - first).size() <= obstacle->fans.of(b - first).size();
    return in_order ? std::array{a, b} : std::array{b, a};
  }

  // The obstacle's BVH is the same each time; it and the one of the ribbon's patches are refitted
  // before use.
  void visit_state(StateArchive& archive) {
    auto& [grid_of_scene, ribbon_body, obstacle_of_scene, bvh_of_grid] = *this;
    ribbon_body.visit_state(archive);
  }

  RibbonGrid grid;
  RibbonBody ribbon;
  std::optional<ObstacleBody> obstacle;
  RibbonBvh ribbon_bvh;
};

}  // namespace ribbon
