#include "simulation/fastening_processor.h"

#include <algorithm>
#include <utility>

#include "simulation/integrate.h"
#include "simulation/recovery.h"
#include "simulation/spring_force.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr double strain_limit = 0.1;   // of the natural length (section 5.5)
constexpr int correction_rounds = 10;  // at most, in one step (section 5.5)
constexpr int settling_rounds = 50;    // at most, before the first step

double shortest_edge_m(const RibbonMesh& ribbon) {
  return std::min(ribbon.length_m / (ribbon.grid.along - 1),
                  ribbon.width_m / (ribbon.grid.across - 1));
}

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

}  // namespace

FasteningProcessor::FasteningProcessor(const Scene& scene, const RibbonMesh& ribbon,
                                       const std::optional<TriangleMesh>& obstacle)
    : step_s_(scene.time.step_s),
      air_resistance_per_s_(scene.air_resistance_per_s),
      cloth_{all_vertices(ribbon, obstacle), Matrix3Xd::Zero(3, ribbon.positions.cols()),
             scene.ribbon.mass_kg / ribbon.grid.particle_count()},
      springs_(spring_network(ribbon.grid, ribbon.length_m, ribbon.width_m, scene.springs)),
      substeps_(stable_substeps(springs_, ribbon.grid.particle_count(), cloth_.particle_mass_kg,
                                air_resistance_per_s_, step_s_)),
      bodies_(std::make_unique<Bodies>(
          Bodies{ribbon.grid, Body(collision_surface(ribbon.grid.triangles()), cloth_.positions),
                 obstacle_body(obstacle, ribbon.grid.particle_count(), cloth_.positions)})),
      strain_correction_(ribbon.grid, ribbon.length_m, ribbon.width_m, strain_limit) {
  const ContactLengths lengths{shortest_edge_m(ribbon),
                               scene.recording.max_position_error_m(ribbon.length_m)};
  contact_ = scene.contact == ContactMethod::paper ? paper_contact(*bodies_, lengths)
                                                   : gated_contact(*bodies_, lengths, step_s_);
  if (scene.fastening)
    fastening_.emplace(*scene.fastening, air_resistance_per_s_, ribbon.grid, cloth_.positions,
                       cloth_.particle_mass_kg);
  if (scene.fastening && scene.fastening->yield_strain)
    yielding_.emplace(ribbon.grid, ribbon.length_m, *scene.fastening->yield_strain);
  settle();
}

// A band that was bent into a drawn curve is strained here and there. Before the first step it is
// corrected as after any other, without force and at rest.
void FasteningProcessor::settle() {
  const Matrix3Xd start = cloth_.positions;
  contact_->after_displacement(start, cloth_);
  for (int round = 0; round < settling_rounds && correct_strain(); ++round)
    contact_->after_smoothing(cloth_);
  cloth_.velocities.setZero();
}

StepReport FasteningProcessor::step() {
  const Matrix3Xd before = cloth_.positions;
  integrate(springs_, fastening_force(), air_resistance_per_s_, step_s_, substeps_, cloth_);
  contact_->after_displacement(before, cloth_);
  correct_strain();
  const int recovery_iterations = contact_->after_smoothing(cloth_);
  ++steps_;
  return {recovery_iterations};
}

int FasteningProcessor::penetrating_edges() {
  return count_penetrating_edges(*bodies_, cloth_.positions);
}

double FasteningProcessor::strain() const {
  return worst_strain(springs_, cloth_.positions);
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

// while ∃ over-stretched edge: apply post-step correction. What moves the particles also changes
// their velocities, so that the springs are not stretched again in the next step. Was there any?
bool FasteningProcessor::correct_strain() {
  const Matrix3Xd before = cloth_.positions;
  int rounds = 0;
  while (rounds < correction_rounds && strain_correction_.any_over_limit(cloth_.positions)) {
    strain_correction_.apply(cloth_.positions);
    ++rounds;
  }
  if (rounds > 0)
    cloth_.velocities += (cloth_.positions - before).leftCols(cloth_.particle_count()) / step_s_;
  return rounds > 0;
}

}  // namespace ribbon
