#include "simulation/step/published_step.h"

#include "simulation/contact/repulsion.h"
#include "simulation/detection/swept_pairs.h"
#include "simulation/state/edge_strain.h"
#include "simulation/step/step_clock.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr int most_detections = 10;   // of detection and repulsion in one step
constexpr int most_corrections = 10;  // of strain in one step (section 5.5)
constexpr double activation = 0.1;    // of the shortest edge

}  // namespace

// ---- Figure 5, from top to bottom

StepReport PublishedStep::advance(Hands* hands, Bodies& bodies, Cloth& cloth) {
  const Matrix3Xd before = cloth.positions;
  integrate(fastening_force(hands, cloth), cloth);  // sections 5.2 and 5.3
  return correct(before, bodies, cloth);
}

StepReport PublishedStep::correct(const Matrix3Xd& before, Bodies& bodies, Cloth& cloth) {
  bool any_collision = true;
  for (int round = 0; round < most_detections && any_collision; ++round)
    any_collision = repel(detect(before, bodies, cloth), before, bodies, cloth);  // section 5.4
  correct_strain(cloth);                                                          // section 5.5
  return recover(bodies, cloth);                                                  // section 5.6
}

// ---- The phases

void PublishedStep::integrate(const Matrix3Xd& force, Cloth& cloth) {
  const PhaseTimer timer(clock_, StepPhase::integration);
  integrator_->displace(force, cloth);
}

std::vector<FeaturePair> PublishedStep::detect(const Matrix3Xd& before, Bodies& bodies,
                                               const Cloth& cloth) {
  const PhaseTimer timer(clock_, StepPhase::detection);
  std::vector<FeaturePair> pairs =
      swept_pairs_by_curvature(bodies, before, cloth.positions, distances_.largest_activation_m());
  clock_.count_detection(pairs.size());
  return pairs;
}

// while ∃ collision: update velocity, displacement.
bool PublishedStep::repel(const std::vector<FeaturePair>& pairs, const Matrix3Xd& before,
                          const Bodies& bodies, Cloth& cloth) {
  const PhaseTimer timer(clock_, StepPhase::repulsion);
  return repel_once(pairs, distances_, friction_, bodies, before, cloth);
}

// while ∃ over-stretched edge: apply post-step correction. What moves the particles also changes
// their velocities, so that the springs are not stretched again in the next step.
void PublishedStep::correct_strain(Cloth& cloth) {
  const PhaseTimer timer(clock_, StepPhase::strain_correction);
  const Matrix3Xd before = cloth.positions;
  int rounds = 0;
  while (rounds < most_corrections && strain_correction_.any_over_limit(cloth.positions)) {
    strain_correction_.apply(cloth.positions);
    ++rounds;
  }
  clock_.count_sweeps(rounds);
  if (rounds > 0) cloth.velocities += (cloth.positions - before) / step_s_;
}

// while ∃ edge penetration: apply error recovery schemes.
StepReport PublishedStep::recover(Bodies& bodies, Cloth& cloth) {
  const PhaseTimer timer(clock_, StepPhase::recovery);
  const RecoveryReport report = ribbon::recover(bodies, recovery_, cloth.positions);
  return {.recovery_iterations = report.iterations,
          .penetrating_edges = report.penetrating_edges,
          .is_over_aimed = strain_correction_.any_over_limit(cloth.positions)};
}

PublishedStep::PublishedStep(const Scene& scene, const RestSize& size, double particle_mass_kg)
    : TimeStep(scene, size, particle_mass_kg),
      distances_(size, {.activation_m = activation * size.shortest_edge_m(),
                        .thickness_m = scene.ribbon.thickness_m}),
      strain_correction_(size, paper_strain_limit),
      recovery_(RecoverySettings::of_edge(size.shortest_edge_m())) {}

}  // namespace ribbon
