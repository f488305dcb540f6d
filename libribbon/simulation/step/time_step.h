// The time step (paper, section 5, Figure 5).
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "geometry/rest_size.h"
#include "scene/scene.h"
#include "simulation/contact/contact_lengths.h"
#include "simulation/contact/repulsion.h"
#include "simulation/detection/bodies.h"
#include "simulation/detection/feature_pairs.h"
#include "simulation/fastening/hands.h"
#include "simulation/integration/integrator.h"
#include "simulation/published/recovery.h"
#include "simulation/published/strain_correction.h"
#include "simulation/state/cloth.h"
#include "simulation/step/gated_motion.h"
#include "simulation/step/stage_clock.h"
#include "simulation/step/step_report.h"
#include "simulation/truncation/contact_constraints.h"
#include "simulation/truncation/row_chain.h"
#include "simulation/truncation/strain_constraints.h"

namespace ribbon {

// At most, of settling before the first step.
inline constexpr int settling_rounds = 50;

// How a band of one rest size moves in one time step, with springs, air and contact as the scene
// wants them. With contact = "gate" the strain correction knows of contact, and positions reach the
// cloth only through the gate, so that what did not intersect at the start never does. With contact
// = "paper" the strain correction may push the ribbon through itself, and schemes A, B and C bring
// it back as well as they can.
class TimeStep {
 public:
  // `lengths`: of a band of that size. contact = "paper" has distances of its own.
  // particle_mass_kg: mean.
  TimeStep(const Scene& scene, const RestSize& size, const ContactLengths& lengths,
           double particle_mass_kg);

  // One time step. hands: null where nothing fastens the ribbon. With the gate it leaves every edge
  // within the limit of strain, if it was so before.
  StepReport take(Hands* hands, Bodies& bodies, Cloth& cloth);

  // Likewise, under a force that is given (3 x particles, N, or no columns for none), in one part
  // of the implicit scheme.
  StepReport advance(const Eigen::Matrix3Xd& force, Bodies& bodies, Cloth& cloth);

  // What follows the integration: cloth.positions are where displacement from `before` (3 x
  // particles) brought the cloth; leaves them where they may be, with velocities that agree.
  StepReport correct(const Eigen::Matrix3Xd& before, Bodies& bodies, Cloth& cloth);

  // Brings the cloth from its positions toward `target` (3 x particles), as far as contact lets,
  // and leaves it at rest.
  void move(const Eigen::Matrix3Xd& target, Bodies& bodies, Cloth& cloth);

  // Corrects up to `rounds` times, until no edge is over the strain limit, and leaves the cloth at
  // rest. The report's recovery iterations are those of all rounds.
  StepReport settle(int rounds, Bodies& bodies, Cloth& cloth);

  // Is every edge within the paper's limit of strain, with what recording may add?
  [[nodiscard]] bool is_within_limit(const Cloth& cloth);

  // No limited edge (limited_edges()) that was within it before a step is further from its rest
  // length afterwards, with what recording may add, as a fraction of it. 0 with contact = "paper",
  // which guarantees nothing.
  [[nodiscard]] double guaranteed_strain() const;

  // Coulomb's coefficient from the next step on; at first it is the scene's.
  void set_friction(double coefficient) { repulsion_.friction = coefficient; }
  // Likewise; nothing where there is none.
  void set_gravity(const std::optional<Eigen::Vector3d>& acceleration_m_s2) {
    integrator_->set_gravity(acceleration_m_s2);
  }

  [[nodiscard]] const Integrator& integrator() const { return *integrator_; }
  // Charged with the stages of all steps.
  [[nodiscard]] StageClock& clock() { return clock_; }
  [[nodiscard]] const StageClock& clock() const { return clock_; }

 private:
  StepReport advance_within_limit(Hands* hands, Bodies& bodies, Cloth& cloth);
  void ease(double fraction);
  StepReport advance_as_published(const Eigen::Matrix3Xd& force, Bodies& bodies, Cloth& cloth);
  [[nodiscard]] int substeps() const { return integrator_->substeps(); }
  [[nodiscard]] int parts_for(const RibbonGrid& grid, const Cloth& cloth) const;
  [[nodiscard]] int most_gates() const;  // in a step
  [[nodiscard]] int gates_for(const Cloth& cloth) const;
  StepReport advance_with_gates(int gates, const Eigen::Matrix3Xd& force, Bodies& bodies,
                                Cloth& cloth);
  StepReport advance_with_gate(int parts, const Eigen::Matrix3Xd& force, Bodies& bodies,
                               Cloth& cloth);
  StepReport correct_with_gate(GatedMotion& motion, const Bodies& bodies, Cloth& cloth);
  StepReport correct_as_published(const Eigen::Matrix3Xd& before, Bodies& bodies, Cloth& cloth);

  const Eigen::Matrix3Xd& fastening_force(Hands* hands, const Cloth& cloth);
  void follow_with(Hands& hands, const Cloth& cloth);
  void integrate(const Eigen::Matrix3Xd& force, Cloth& cloth);
  void hold_force(const Eigen::Matrix3Xd& force, const Cloth& cloth);
  void integrate_substep(Cloth& cloth);
  std::vector<FeaturePair> detect(const Eigen::Matrix3Xd& before, Bodies& bodies,
                                  const Cloth& cloth);
  bool repel(const std::vector<FeaturePair>& pairs, const Eigen::Matrix3Xd& before,
             const Bodies& bodies, Cloth& cloth);
  void correct_strain(Cloth& cloth);
  void find_contacts(const GatedMotion& motion, const Eigen::Matrix3Xd& target,
                     const Bodies& bodies, const Eigen::Vector3d& fall_m = Eigen::Vector3d::Zero());
  void shorten_loose_ends(Cloth& cloth);
  void correct_strain_and_contact(int most_sweeps, const Eigen::Matrix3Xd& before,
                                  const Bodies& bodies, Cloth& cloth);
  StepReport pass_gate(GatedMotion& motion, Cloth& cloth);
  int truncate(GatedMotion& motion, Cloth& cloth);
  StepReport recover(Bodies& bodies, Cloth& cloth);
  [[nodiscard]] StrainExcess strain_excess(const Cloth& cloth);

  ContactMethod contact_;
  double step_s_;
  std::unique_ptr<Integrator> integrator_;
  PairDistances distances_;
  RepulsionSettings repulsion_;
  StrainCorrectionScene strain_correction_;  // of the gate
  StrainConstraints strain_constraints_;
  RowChain loose_rows_;
  SweepActivity activity_;
  ContactConstraints contacts_;
  Gate gate_;
  PublishedStrainCorrection published_correction_;
  RecoverySettings recovery_;
  StageClock clock_;
  // Kept for their memory alone.
  Cloth before_step_;
  Eigen::Matrix3Xd before_substep_;  // positions
  Eigen::Matrix3Xd expected_;        // positions, as far as velocities tell
  Eigen::Matrix3Xd no_force_;        // no columns
};

}  // namespace ribbon
