#include "simulation/step/gated_step.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/vectors.h"
#include "ribbon_mesh/springs.h"
#include "simulation/step/step_clock.h"

namespace ribbon {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

namespace {

constexpr int most_eased_attempts = 10;  // of one step: with a thousandth of the force at last
constexpr double most_change = 0.03;     // of an edge's length, in a part of a step
// More after the last substep, as far as there is need, so that little is truncated.
constexpr int sweeps_in_substep = 3;
constexpr int most_sweeps_before_gate = 30;

}  // namespace

// ---- Figure 5, from top to bottom

// A step that would leave an edge beyond the limit of strain is taken again, through the gate twice
// as often, at last as often as it may. What the cloth cannot bear even then, hands do not get: the
// step is taken with half of their force, a quarter of the weight and from half of the velocities,
// at last from rest; and, since a jammed ribbon strains itself, with a quarter of the springs'
// stiffness and of what contact would open. If nothing helps, the ribbon stays where it is.
StepReport GatedStep::advance(Hands* hands, Bodies& bodies, Cloth& cloth) {
  before_step_ = cloth;
  if (integrator_->method() == IntegrationMethod::implicit)
    integrator_->divide_steps(parts_for(bodies.grid, cloth));
  int gates = gates_for(cloth);
  for (int eased_attempts = 0;; gates = std::min(2 * gates, most_gates())) {
    const StepReport report =
        advance_through(gates, fastening_force(hands, cloth), bodies, cloth);  // section 5.2
    if (report.is_bearable || eased_attempts == most_eased_attempts) {
      if (!report.is_bearable) cloth = before_step_;
      ease(1);
      return report;
    }
    if (gates == most_gates()) {
      ++eased_attempts;
      before_step_.velocities *= eased_attempts < most_eased_attempts ? 0.5 : 0;
      ease(std::ldexp(1.0, -2 * eased_attempts));
      if (hands != nullptr) hands->ease();
    }
    cloth = before_step_;
  }
}

void GatedStep::ease(double fraction) {
  integrator_->ease(fraction);
  contacts_.ease(fraction);
}

StepReport GatedStep::advance_under(const Matrix3Xd& force, Bodies& bodies, Cloth& cloth) {
  return advance_to_gate(substeps(), force, bodies, cloth);
}

// Contact and strain answer to each part of a step. The more the ways of neighbours differ, the
// more there is to answer to, and one long part leaves more than many sweeps can pass on.
int GatedStep::parts_for(const RibbonGrid& grid, const Cloth& cloth) const {
  const double change = step_s_ * change_per_s(grid, cloth.positions, cloth.velocities);
  return static_cast<int>(
      std::clamp(std::ceil(change / most_change), 1.0, static_cast<double>(most_implicit_parts)));
}

// What needs more of them is eased.
int GatedStep::most_gates() const {
  return std::min(32, substeps());
}

// The farther the particles go, the more their ways differ and the more of them could meet: where
// they pass several edges in a step, it is quicker to take it in parts.
int GatedStep::gates_for(const Cloth& cloth) const {
  double fastest_m_s = 0;
  for (const auto& velocity : cloth.velocities.colwise())
    fastest_m_s = std::max(fastest_m_s, length_of(velocity));
  const double gates = std::ceil(step_s_ * fastest_m_s / gate_.farthest_m);
  return static_cast<int>(std::clamp(gates, 1.0, static_cast<double>(most_gates())));
}

// contact = "gate", so many times, after equal numbers of substeps.
StepReport GatedStep::advance_through(int gates, const Matrix3Xd& force, Bodies& bodies,
                                      Cloth& cloth) {
  StepReport report;
  for (int gate = 0, gone = 0; gate < gates; ++gate) {
    const int end = substeps() * (gate + 1) / gates;
    const int truncated = report.truncated;
    report = advance_to_gate(end - gone, force, bodies, cloth);
    report.truncated = std::max(report.truncated, truncated);  // for section 5.6
    gone = end;
  }
  return report;
}

// Once, after so many substeps. One detection serves them all, and there is nothing to recover
// from. Springs press what lies on each other together, all the more the longer they are left
// alone; so contact and strain answer to each substep, and what rests hardly moves.
StepReport GatedStep::advance_to_gate(int parts, const Matrix3Xd& force, Bodies& bodies,
                                      Cloth& cloth) {
  const double duration_s = step_s_ * parts / substeps();
  GatedMotion motion(gate_, cloth.positions, duration_s, bodies, clock_);
  expected_ = cloth.positions + duration_s * cloth.velocities;
  const Vector3d fall_m = integrator_->fall_m(duration_s);
  motion.detect(expected_, expected_, fall_m);  // section 5.4
  find_contacts(motion, expected_, bodies, fall_m);
  hold_force(force, cloth);
  for (int part = 0; part < parts; ++part) {
    if (friction_ > 0) before_substep_ = cloth.positions;
    integrate_substep(cloth);  // section 5.3
    const bool is_last = part + 1 == parts;
    correct_strain_and_contact(is_last ? most_sweeps_before_gate : sweeps_in_substep,
                               before_substep_, bodies, cloth);  // cf. sections 5.4.2 and 5.5
  }
  return correct_within(motion, bodies, cloth);
}

StepReport GatedStep::correct_within(GatedMotion& motion, const Bodies& bodies, Cloth& cloth) {
  StepReport report = pass_gate(motion, cloth);
  for (int round = 0; round < strain_correction_.most_rounds && report.is_over_aimed; ++round) {
    find_contacts(motion, cloth.positions, bodies);
    shorten_loose_ends(cloth);
    correct_strain_and_contact(strain_correction_.most_sweeps, motion.free_positions(), bodies,
                               cloth);  // cf. section 5.5
    const int truncated = report.truncated;
    report = pass_gate(motion, cloth);
    report.truncated = std::max(report.truncated, truncated);  // for section 5.6
  }
  return report;
}

// ---- The phases

void GatedStep::hold_force(const Matrix3Xd& force, const Cloth& cloth) {
  const PhaseTimer timer(clock_, StepPhase::integration);
  integrator_->hold_force(force, cloth);
}

void GatedStep::integrate_substep(Cloth& cloth) {
  const PhaseTimer timer(clock_, StepPhase::integration);
  integrator_->displace_in_substep(cloth);
}

void GatedStep::find_contacts(const GatedMotion& motion, const Matrix3Xd& target,
                              const Bodies& bodies, const Vector3d& fall_m) {
  const PhaseTimer timer(clock_, StepPhase::repulsion);
  contacts_.find(motion.candidates(), bodies, gate_.distances, motion.slack_m(),
                 motion.free_positions(), target, fall_m);
}

// What sweeps have not let go is more than they can pass on.
void GatedStep::shorten_loose_ends(Cloth& cloth) {
  const PhaseTimer timer(clock_, StepPhase::strain_correction);
  loose_rows_.break_at(contacts_.found());
  loose_rows_.shorten(cloth);
}

// Corrected alone, edges would be pressed into contact, and stretched again by it; so both are
// satisfied in turn.
void GatedStep::correct_strain_and_contact(int most_sweeps, const Matrix3Xd& before,
                                           const Bodies& bodies, Cloth& cloth) {
  const PhaseTimer timer(clock_, StepPhase::strain_correction);
  activity_.reset();
  contacts_.begin_sweeps();
  bool any = true;
  int sweeps = 0;
  for (; sweeps < most_sweeps && any; ++sweeps) {
    any = contacts_.keep_apart(friction_, before, bodies, activity_, cloth);
    any = strain_constraints_.tighten(activity_, cloth) || any;
  }
  clock_.count_sweeps(sweeps);
}

StepReport GatedStep::pass_gate(GatedMotion& motion, Cloth& cloth) {
  motion.detect_if_outgrown(cloth.positions);
  const int truncated = truncate(motion, cloth);
  const StrainExcess strain = strain_excess(cloth);
  return {.truncated = truncated,
          .is_bearable = strain.is_bearable,
          .is_over_aimed = strain.beyond_aimed > strain_left_over};
}

// What was truncated is taken from the velocity, as far as there is any in that direction: a
// repulsion or correction that did not get through must not throw a particle the other way.
int GatedStep::truncate(GatedMotion& motion, Cloth& cloth) {
  const PhaseTimer timer(clock_, StepPhase::truncation);
  const int truncated = motion.truncate(cloth.positions);
  for (Eigen::Index particle = 0; particle < cloth.particle_count(); ++particle) {
    const Vector3d lost = cloth.positions.col(particle) - motion.free_positions().col(particle);
    const double lost_m = length_of(lost);
    const double speed_m_s = lost_m > 0 ? dot(lost, cloth.velocities.col(particle)) / lost_m : 0;
    if (speed_m_s > 0)
      cloth.velocities.col(particle) -=
          std::min(speed_m_s, lost_m / motion.duration_s()) * lost / lost_m;
  }
  cloth.positions = motion.free_positions();
  return truncated;
}

StrainExcess GatedStep::strain_excess(const Cloth& cloth) {
  const PhaseTimer timer(clock_, StepPhase::strain_correction);
  return strain_constraints_.excess(cloth.positions);
}

bool GatedStep::is_bearable(const Cloth& cloth) {
  return strain_excess(cloth).is_bearable;
}

// ---- Before the first step

StepReport GatedStep::correct(const Matrix3Xd& before, Bodies& bodies, Cloth& cloth) {
  GatedMotion motion(gate_, before, step_s_, bodies, clock_);
  motion.detect(before, cloth.positions);
  find_contacts(motion, cloth.positions, bodies);
  correct_strain_and_contact(strain_correction_.most_sweeps, before, bodies, cloth);
  return correct_within(motion, bodies, cloth);
}

void GatedStep::move(const Matrix3Xd& target, Bodies& bodies, Cloth& cloth) {
  const Matrix3Xd before = cloth.positions;
  cloth.positions = target;
  correct(before, bodies, cloth);
  cloth.velocities.setZero();
}

// ---- Settings

namespace {

StrainConstraints strain_constraints(const Scene& scene, const RestSize& size, double rounding_m) {
  std::vector<LimitedFamily> limited;
  for (const SpringFamily& family : limited_families(limited_edges(scene), size))
    limited.push_back(
        {family, aimed_strain(scene.strain_correction.strain, family.rest_length_m, rounding_m),
         most_strain(family.rest_length_m, rounding_m)});
  return {size.grid, std::move(limited)};
}

}  // namespace

GatedStep::GatedStep(const Scene& scene, const RestSize& size, const ContactLengths& lengths,
                     double particle_mass_kg)
    : TimeStep(scene, size, particle_mass_kg),
      strain_correction_(scene.strain_correction),
      strain_constraints_(strain_constraints(scene, size, lengths.rounding_m)),
      loose_rows_(size,
                  aimed_strain(scene.strain_correction.strain, size.along_m(), lengths.rounding_m)),
      activity_(strain_constraints_.activity()),
      contacts_(lightness(size)),
      gate_(size, PairDistances(size, lengths)) {}

}  // namespace ribbon
