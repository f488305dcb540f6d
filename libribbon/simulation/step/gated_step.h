// The time step (paper, section 5, Figure 5) with the gate: contact = "gate".
#pragma once

#include <Eigen/Core>

#include "geometry/rest_size.h"
#include "scene/scene.h"
#include "simulation/contact/contact_lengths.h"
#include "simulation/detection/bodies.h"
#include "simulation/fastening/hands.h"
#include "simulation/state/cloth.h"
#include "simulation/state/edge_strain.h"
#include "simulation/step/gated_motion.h"
#include "simulation/step/step_report.h"
#include "simulation/step/time_step.h"
#include "simulation/truncation/contact_constraints.h"
#include "simulation/truncation/row_chain.h"
#include "simulation/truncation/strain_constraints.h"
#include "simulation/truncation/sweep_activity.h"

namespace ribbon {

// The strain correction knows of contact, and positions reach the cloth only through the gate, so
// that what did not intersect at the start never does. A step leaves every edge within the limit of
// strain, if it was so before.
class GatedStep : public TimeStep {
 public:
  // `lengths`: of a band of that size. particle_mass_kg: mean.
  GatedStep(const Scene& scene, const RestSize& size, const ContactLengths& lengths,
            double particle_mass_kg);

  // Moves the cloth by one step without rounding its velocities, under a force that is given (3 x
  // particles, N, or no columns for none), once through the gate, whatever it strains.
  StepReport advance_under(const Eigen::Matrix3Xd& force, Bodies& bodies, Cloth& cloth);

  StepReport correct(const Eigen::Matrix3Xd& before, Bodies& bodies, Cloth& cloth) override;

  // Brings the cloth from its positions toward `target` (3 x particles), as far as contact lets,
  // and leaves it at rest.
  void move(const Eigen::Matrix3Xd& target, Bodies& bodies, Cloth& cloth);

  // Is every edge within the paper's limit of strain, with what recording may add?
  [[nodiscard]] bool is_bearable(const Cloth& cloth);

  [[nodiscard]] double guaranteed_strain() const override { return paper_strain_limit; }
  [[nodiscard]] double held_strain() const override { return strain_constraints_.least_held(); }

 private:
  StepReport advance(Hands* hands, Bodies& bodies, Cloth& cloth) override;
  void ease(double fraction);

  [[nodiscard]] int substeps() const { return integrator_->substeps(); }
  [[nodiscard]] int parts_for(const RibbonGrid& grid, const Cloth& cloth) const;
  [[nodiscard]] int most_gates() const;  // in a step
  [[nodiscard]] int gates_for(const Cloth& cloth) const;
  StepReport advance_through(int gates, const Eigen::Matrix3Xd& force, Bodies& bodies,
                             Cloth& cloth);
  StepReport advance_to_gate(int parts, const Eigen::Matrix3Xd& force, Bodies& bodies,
                             Cloth& cloth);
  StepReport correct_within(GatedMotion& motion, const Bodies& bodies, Cloth& cloth);

  void hold_force(const Eigen::Matrix3Xd& force, const Cloth& cloth);
  void integrate_substep(Cloth& cloth);
  void find_contacts(const GatedMotion& motion, const Eigen::Matrix3Xd& target,
                     const Bodies& bodies, const Eigen::Vector3d& fall_m = Eigen::Vector3d::Zero());
  void shorten_loose_ends(Cloth& cloth);
  void correct_strain_and_contact(int most_sweeps, const Eigen::Matrix3Xd& before,
                                  const Bodies& bodies, Cloth& cloth);
  StepReport pass_gate(GatedMotion& motion, Cloth& cloth);
  int truncate(GatedMotion& motion, Cloth& cloth);
  [[nodiscard]] StrainExcess strain_excess(const Cloth& cloth);

  StrainCorrectionScene strain_correction_;
  StrainConstraints strain_constraints_;
  RowChain loose_rows_;
  SweepActivity activity_;
  ContactConstraints contacts_;
  Gate gate_;
  // Kept for their memory alone.
  Cloth before_step_;
  Eigen::Matrix3Xd before_substep_;  // positions
  Eigen::Matrix3Xd expected_;        // positions, as far as velocities tell
};

}  // namespace ribbon
