#include "simulation/step/time_step.h"

#include <span>

#include "ribbon_mesh/springs.h"
#include "simulation/state/grip.h"
#include "simulation/step/gated_step.h"
#include "simulation/step/published_step.h"

namespace ribbon {

using Eigen::Matrix3Xd;

StepReport TimeStep::take(Hands* hands, Bodies& bodies, Cloth& cloth) {
  StepReport report = advance(hands, bodies, cloth);
  clock_.count_parts(integrator_->substeps());
  cloth.round_velocities();
  if (hands == nullptr) return report;
  follow_with(*hands, cloth);
  report.pull = hands->force_fraction();
  return report;
}

const Matrix3Xd& TimeStep::fastening_force(Hands* hands, const Cloth& cloth) {
  const PhaseTimer timer(clock_, StepPhase::fastening_force);
  const Matrix3Xd& force = hands != nullptr ? hands->pull(cloth) : no_force_;
  integrator_->take_grips(hands != nullptr ? hands->grips() : std::span<const Grip>());
  return force;
}

// The hands measure how far the ribbon followed their pull.
void TimeStep::follow_with(Hands& hands, const Cloth& cloth) {
  const PhaseTimer timer(clock_, StepPhase::fastening_force);
  hands.follow(cloth);
}

StepReport TimeStep::settle(int rounds, Bodies& bodies, Cloth& cloth) {
  StepReport last{.is_over_aimed = true};
  for (int round = 0; round < rounds && last.is_over_aimed; ++round) {
    const Matrix3Xd before = cloth.positions;
    const int recovery_iterations = last.recovery_iterations;
    last = correct(before, bodies, cloth);
    last.recovery_iterations += recovery_iterations;
  }
  cloth.velocities.setZero();
  return last;
}

TimeStep::TimeStep(const Scene& scene, const RestSize& size, double particle_mass_kg)
    : step_s_(scene.time.step_s),
      friction_(scene.friction),
      integrator_(
          suitable_integrator(scene.time, scene.contact, spring_network(size, scene.springs),
                              {scene.time.step_s, particle_mass_kg, scene.air_resistance_per_s,
                               scene.gravity_m_s2, scene.time.tolerance, lightness(size)})) {}

std::unique_ptr<TimeStep> create_time_step(const Scene& scene, const RestSize& size,
                                           const ContactLengths& lengths, double particle_mass_kg) {
  if (scene.contact == ContactMethod::paper)
    return std::make_unique<PublishedStep>(scene, size, particle_mass_kg);
  return std::make_unique<GatedStep>(scene, size, lengths, particle_mass_kg);
}

}  // namespace ribbon
