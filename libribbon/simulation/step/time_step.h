// The time step (paper, section 5, Figure 5).
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "geometry/rest_size.h"
#include "scene/scene.h"
#include "simulation/contact/contact_lengths.h"
#include "simulation/detection/bodies.h"
#include "simulation/fastening/hands.h"
#include "simulation/integration/integrator.h"
#include "simulation/state/cloth.h"
#include "simulation/step/step_clock.h"
#include "simulation/step/step_report.h"

namespace ribbon {

// At most, of settling before the first step.
inline constexpr int settling_rounds = 50;

// How a band of one rest size moves in one time step, with springs and air as the scene wants them:
// with the gate (gated_step.h) or as published (published_step.h).
class TimeStep {
 public:
  virtual ~TimeStep() = default;
  TimeStep(const TimeStep&) = delete;
  TimeStep& operator=(const TimeStep&) = delete;

  // One time step. hands: null where nothing fastens the ribbon.
  StepReport take(Hands* hands, Bodies& bodies, Cloth& cloth);

  // What follows the integration: cloth.positions are where displacement from `before` (3 x
  // particles) brought the cloth; leaves them where they may be, with velocities that agree.
  virtual StepReport correct(const Eigen::Matrix3Xd& before, Bodies& bodies, Cloth& cloth) = 0;

  // Corrects up to `rounds` times, until every edge is as is aimed at, and leaves the cloth at
  // rest. The report's recovery iterations are those of all rounds.
  StepReport settle(int rounds, Bodies& bodies, Cloth& cloth);

  // No limited edge (limited_edges()) that was within it before a step is further from its rest
  // length afterwards, with what recording may add, as a fraction of it. 0: nothing is guaranteed.
  [[nodiscard]] virtual double guaranteed_strain() const = 0;
  // To what strain correction brings the edges that it holds to least, as a fraction of their
  // length at rest: the less, the more recording may add. Infinite where it holds none.
  [[nodiscard]] virtual double held_strain() const = 0;

  // Coulomb's coefficient from the next step on; at first it is the scene's.
  void set_friction(double coefficient) { friction_ = coefficient; }
  // Likewise; nothing where there is none.
  void set_gravity(const std::optional<Eigen::Vector3d>& acceleration_m_s2) {
    integrator_->set_gravity(acceleration_m_s2);
  }

  [[nodiscard]] const Integrator& integrator() const { return *integrator_; }
  // Of all steps.
  [[nodiscard]] const PhaseSums& phase_sums() const { return clock_.sums(); }

 protected:
  // particle_mass_kg: mean.
  TimeStep(const Scene& scene, const RestSize& size, double particle_mass_kg);

  // All phases of a step, under the force of the hands.
  virtual StepReport advance(Hands* hands, Bodies& bodies, Cloth& cloth) = 0;

  // The first phase: 3 x particles, N, or no columns for none.
  const Eigen::Matrix3Xd& fastening_force(Hands* hands, const Cloth& cloth);

  double step_s_;
  double friction_;
  std::unique_ptr<Integrator> integrator_;
  StepClock clock_;

 private:
  void follow_with(Hands& hands, const Cloth& cloth);

  Eigen::Matrix3Xd no_force_;  // no columns
};

// As scene.contact wants it. `lengths`: of a band of that size.
std::unique_ptr<TimeStep> create_time_step(const Scene& scene, const RestSize& size,
                                           const ContactLengths& lengths, double particle_mass_kg);

}  // namespace ribbon
