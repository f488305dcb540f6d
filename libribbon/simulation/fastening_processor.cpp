#include "simulation/fastening_processor.h"

#include <utility>

#include "simulation/recovery.h"
#include "simulation/scene_limits.h"
#include "simulation/spring_force.h"
#include "simulation/width_growth.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr int settling_rounds = 50;  // at most, before the first step

// Particles first, the obstacle's vertices behind them.
Matrix3Xd all_vertices(const RibbonMesh& ribbon, const std::optional<TriangleMesh>& obstacle) {
  const Eigen::Index particles = ribbon.positions.cols();
  Matrix3Xd all(3, particles + (obstacle ? obstacle->vertices.cols() : 0));
  all.leftCols(particles) = ribbon.positions;
  if (obstacle) all.rightCols(obstacle->vertices.cols()) = obstacle->vertices.cast<double>();
  return all;
}

std::optional<Body> obstacle_body(const std::optional<TriangleMesh>& obstacle, int first_vertex,
                                  const Matrix3Xd& positions) {
  if (!obstacle) return std::nullopt;
  return Body(collision_surface(obstacle->triangles.array() + first_vertex), positions);
}

std::unique_ptr<Bodies> bodies_of(const RibbonGrid& grid,
                                  const std::optional<TriangleMesh>& obstacle,
                                  const Matrix3Xd& positions) {
  return std::make_unique<Bodies>(
      Bodies{grid, Body(collision_surface(grid.triangles()), positions),
             obstacle_body(obstacle, grid.particle_count(), positions)});
}

}  // namespace

FasteningProcessor::FasteningProcessor(const Scene& scene, const RibbonMesh& ribbon,
                                       const std::optional<TriangleMesh>& obstacle)
    : step_s_(scene.time.step_s),
      cloth_{all_vertices(ribbon, obstacle), Matrix3Xd::Zero(3, ribbon.positions.cols()),
             scene.ribbon.mass_kg / ribbon.grid.particle_count()},
      bodies_(bodies_of(ribbon.grid, obstacle, cloth_.positions)),
      deformation_(scene, natural_size(ribbon, 1), cloth_.particle_mass_kg, *bodies_) {}

Result<FasteningProcessor> FasteningProcessor::create(const Scene& scene, const RibbonMesh& ribbon,
                                                      const std::optional<TriangleMesh>& obstacle) {
  FasteningProcessor processor(scene, ribbon, obstacle);
  if (auto begun = processor.begin(scene, ribbon); !begun) return tl::unexpected(begun.error());
  return processor;
}

Result<void> FasteningProcessor::begin(const Scene& scene, const RibbonMesh& ribbon) {
  const auto kept =
      check_limits(scene, natural_size(ribbon, 1), deformation_.substeps(), cloth_.positions);
  if (!kept) return kept;
  if (scene.contact == ContactMethod::gate) {
    const auto start = find_free_start(scene, ribbon, *bodies_, cloth_);
    if (!start) return tl::unexpected(start.error());
    start_ = *start;
  }
  // A band that was bent into a drawn curve is strained here and there. Before the first step it is
  // corrected as after any other, without force and at rest.
  deformation_.move(cloth_.positions, cloth_);
  start_.recovery_iterations += deformation_.settle(settling_rounds, cloth_);
  if (start_.recovery_iterations > 0) start_.kind = StartKind::recovered;

  if (scene.fastening)
    fastening_.emplace(*scene.fastening, scene.air_resistance_per_s, ribbon.grid, cloth_.positions,
                       cloth_.particle_mass_kg);
  if (scene.fastening && scene.fastening->yield_strain)
    yielding_.emplace(ribbon.grid, ribbon.length_m, *scene.fastening->yield_strain);
  return {};
}

StepReport FasteningProcessor::step() {
  ++steps_;
  return {deformation_.step(fastening_force(), cloth_)};
}

int FasteningProcessor::penetrating_edges() {
  return count_penetrating_edges(*bodies_, cloth_.positions);
}

double FasteningProcessor::strain() const {
  return worst_strain(deformation_.springs(), cloth_.positions);
}

Matrix3Xd FasteningProcessor::positions() const {
  return cloth_.positions.leftCols(cloth_.particle_count());
}

Matrix3Xd FasteningProcessor::fastening_force() {
  if (!fastening_) return {3, 0};
  Matrix3Xd force = fastening_->at(cloth_.positions);
  if (yielding_) force *= yielding_->feel(cloth_.positions);
  return force;
}

}  // namespace ribbon
