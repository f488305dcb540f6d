#include "simulation/step/time_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/vectors.h"
#include "ribbon_mesh/springs.h"
#include "simulation/detection/swept_pairs.h"
#include "simulation/state/edge_strain.h"
#include "simulation/truncation/contact_constraints.h"

namespace ribbon {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// ---- Figure 5, from top to bottom

namespace {

constexpr int most_eased_attempts = 10;  // of one step: with a thousandth of the force at last
constexpr double most_change = 0.03;     // of an edge's length, in a part of a step

}  // namespace

StepReport TimeStep::take(Hands* hands, Bodies& bodies, Cloth& cloth) {
  StepReport report = contact_ == ContactMethod::paper
                          ? advance(fastening_force(hands, cloth), bodies, cloth)
                          : advance_within_limit(hands, bodies, cloth);
  clock_.count_parts(substeps());
  cloth.round_velocities();
  if (hands == nullptr) return report;
  follow_with(*hands, cloth);
  report.pull = hands->force_fraction();
  return report;
}

// A step that would leave an edge beyond the limit of strain is taken again, through the gate twice
// as often, at last as often as it may. What the cloth cannot bear even then, hands do not get: the
// step is taken with half of their force, a quarter of the weight and from half of the velocities,
// at last from rest; and, since a jammed ribbon strains itself, with a quarter of the springs'
// stiffness and of what contact would open. If nothing helps, the ribbon stays where it is.
StepReport TimeStep::advance_within_limit(Hands* hands, Bodies& bodies, Cloth& cloth) {
  before_step_ = cloth;
  if (integrator_->method() == IntegrationMethod::implicit)
    integrator_->divide_steps(parts_for(bodies.grid, cloth));
  int gates = gates_for(cloth);
  for (int eased_attempts = 0;; gates = std::min(2 * gates, most_gates())) {
    const StepReport report =
        advance_with_gates(gates, fastening_force(hands, cloth), bodies, cloth);  // section 5.2
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

void TimeStep::ease(double fraction) {
  integrator_->ease(fraction);
  contacts_.ease(fraction);
}

StepReport TimeStep::advance(const Matrix3Xd& force, Bodies& bodies, Cloth& cloth) {
  return contact_ == ContactMethod::paper ? advance_as_published(force, bodies, cloth)
                                          : advance_with_gate(substeps(), force, bodies, cloth);
}

namespace {

constexpr int most_detections = 10;   // as published, of detection and repulsion in one step
constexpr int most_corrections = 10;  // as published, of strain in one step (section 5.5)
// With the gate: more after the last substep, as far as there is need, so that little is truncated.
constexpr int sweeps_in_substep = 3;
constexpr int most_sweeps_before_gate = 30;

}  // namespace

// contact = "paper".
StepReport TimeStep::advance_as_published(const Matrix3Xd& force, Bodies& bodies, Cloth& cloth) {
  const Matrix3Xd before = cloth.positions;
  integrate(force, cloth);  // section 5.3
  return correct_as_published(before, bodies, cloth);
}

StepReport TimeStep::correct_as_published(const Matrix3Xd& before, Bodies& bodies, Cloth& cloth) {
  bool any_collision = true;
  for (int round = 0; round < most_detections && any_collision; ++round)
    any_collision = repel(detect(before, bodies, cloth), before, bodies, cloth);  // section 5.4
  correct_strain(cloth);                                                          // section 5.5
  return recover(bodies, cloth);                                                  // section 5.6
}

// Contact and strain answer to each part of a step. The more the ways of neighbours differ, the
// more there is to answer to, and one long part leaves more than many sweeps can pass on.
int TimeStep::parts_for(const RibbonGrid& grid, const Cloth& cloth) const {
  const double change = step_s_ * change_per_s(grid, cloth.positions, cloth.velocities);
  return static_cast<int>(
      std::clamp(std::ceil(change / most_change), 1.0, static_cast<double>(most_implicit_parts)));
}

// What needs more of them is eased.
int TimeStep::most_gates() const {
  return std::min(32, substeps());
}

// The farther the particles go, the more their ways differ and the more of them could meet: where
// they pass several edges in a step, it is quicker to take it in parts.
int TimeStep::gates_for(const Cloth& cloth) const {
  double fastest_m_s = 0;
  for (const auto& velocity : cloth.velocities.colwise())
    fastest_m_s = std::max(fastest_m_s, length_of(velocity));
  const double gates = std::ceil(step_s_ * fastest_m_s / gate_.farthest_m);
  return static_cast<int>(std::clamp(gates, 1.0, static_cast<double>(most_gates())));
}

// contact = "gate", so many times, after equal numbers of substeps.
StepReport TimeStep::advance_with_gates(int gates, const Matrix3Xd& force, Bodies& bodies,
                                        Cloth& cloth) {
  StepReport report;
  for (int gate = 0, gone = 0; gate < gates; ++gate) {
    const int end = substeps() * (gate + 1) / gates;
    const int truncated = report.truncated;
    report = advance_with_gate(end - gone, force, bodies, cloth);
    report.truncated = std::max(report.truncated, truncated);  // for section 5.6
    gone = end;
  }
  return report;
}

// Once, after so many substeps. One detection serves them all, and there is nothing to recover
// from. Springs press what lies on each other together, all the more the longer they are left
// alone; so contact and strain answer to each substep, and what rests hardly moves.
StepReport TimeStep::advance_with_gate(int parts, const Matrix3Xd& force, Bodies& bodies,
                                       Cloth& cloth) {
  const double duration_s = step_s_ * parts / substeps();
  GatedMotion motion(gate_, cloth.positions, duration_s, bodies, clock_);
  expected_ = cloth.positions + duration_s * cloth.velocities;
  const Vector3d fall_m = integrator_->fall_m(duration_s);
  motion.detect(expected_, expected_, fall_m);  // section 5.4
  find_contacts(motion, expected_, bodies, fall_m);
  hold_force(force, cloth);
  for (int part = 0; part < parts; ++part) {
    if (repulsion_.friction > 0) before_substep_ = cloth.positions;
    integrate_substep(cloth);  // section 5.3
    const bool is_last = part + 1 == parts;
    correct_strain_and_contact(is_last ? most_sweeps_before_gate : sweeps_in_substep,
                               before_substep_, bodies, cloth);  // cf. sections 5.4.2 and 5.5
  }
  return correct_with_gate(motion, bodies, cloth);
}

StepReport TimeStep::correct_with_gate(GatedMotion& motion, const Bodies& bodies, Cloth& cloth) {
  StepReport report = pass_gate(motion, cloth);
  for (int round = 0; round < strain_correction_.most_rounds && report.is_over_limit; ++round) {
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

// ---- The stages

const Matrix3Xd& TimeStep::fastening_force(Hands* hands, const Cloth& cloth) {
  const StageTimer timer(clock_, StepStage::fastening_force);
  const Matrix3Xd& force = hands != nullptr ? hands->pull(cloth) : no_force_;
  integrator_->take_grips(hands != nullptr ? hands->grips() : std::span<const Grip>());
  return force;
}

// The hands measure how far the ribbon followed their pull.
void TimeStep::follow_with(Hands& hands, const Cloth& cloth) {
  const StageTimer timer(clock_, StepStage::fastening_force);
  hands.follow(cloth);
}

void TimeStep::integrate(const Matrix3Xd& force, Cloth& cloth) {
  const StageTimer timer(clock_, StepStage::integration);
  integrator_->displace(force, cloth);
}

void TimeStep::hold_force(const Matrix3Xd& force, const Cloth& cloth) {
  const StageTimer timer(clock_, StepStage::integration);
  integrator_->hold_force(force, cloth);
}

void TimeStep::integrate_substep(Cloth& cloth) {
  const StageTimer timer(clock_, StepStage::integration);
  integrator_->displace_in_substep(cloth);
}

std::vector<FeaturePair> TimeStep::detect(const Matrix3Xd& before, Bodies& bodies,
                                          const Cloth& cloth) {
  const StageTimer timer(clock_, StepStage::detection);
  std::vector<FeaturePair> pairs =
      swept_pairs_by_curvature(bodies, before, cloth.positions, distances_.largest_activation_m());
  clock_.count_detection(pairs.size());
  return pairs;
}

// while ∃ collision: update velocity, displacement.
bool TimeStep::repel(const std::vector<FeaturePair>& pairs, const Matrix3Xd& before,
                     const Bodies& bodies, Cloth& cloth) {
  const StageTimer timer(clock_, StepStage::repulsion);
  return repel_once(pairs, distances_, repulsion_, bodies, before, cloth);
}

// while ∃ over-stretched edge: apply post-step correction. What moves the particles also changes
// their velocities, so that the springs are not stretched again in the next step.
void TimeStep::correct_strain(Cloth& cloth) {
  const StageTimer timer(clock_, StepStage::strain_correction);
  const Matrix3Xd before = cloth.positions;
  int rounds = 0;
  while (rounds < most_corrections && published_correction_.any_over_limit(cloth.positions)) {
    published_correction_.apply(cloth.positions);
    ++rounds;
  }
  clock_.count_sweeps(rounds);
  if (rounds > 0) cloth.velocities += (cloth.positions - before) / step_s_;
}

void TimeStep::find_contacts(const GatedMotion& motion, const Matrix3Xd& target,
                             const Bodies& bodies, const Vector3d& fall_m) {
  const StageTimer timer(clock_, StepStage::repulsion);
  contacts_.find(motion.candidates(), bodies, distances_, motion.slack_m(), motion.free_positions(),
                 target, fall_m);
}

// What sweeps have not let go is more than they can pass on.
void TimeStep::shorten_loose_ends(Cloth& cloth) {
  const StageTimer timer(clock_, StepStage::strain_correction);
  loose_rows_.break_at(contacts_.found());
  loose_rows_.shorten(cloth);
}

// Corrected alone, edges would be pressed into contact, and stretched again by it; so both are
// satisfied in turn.
void TimeStep::correct_strain_and_contact(int most_sweeps, const Matrix3Xd& before,
                                          const Bodies& bodies, Cloth& cloth) {
  const StageTimer timer(clock_, StepStage::strain_correction);
  activity_.reset();
  contacts_.begin_sweeps();
  bool any = true;
  int sweeps = 0;
  for (; sweeps < most_sweeps && any; ++sweeps) {
    any = contacts_.keep_apart(repulsion_.friction, before, bodies, activity_, cloth);
    any = strain_constraints_.tighten(activity_, cloth) || any;
  }
  clock_.count_sweeps(sweeps);
}

StepReport TimeStep::pass_gate(GatedMotion& motion, Cloth& cloth) {
  motion.detect_if_outgrown(cloth.positions);
  const int truncated = truncate(motion, cloth);
  const StrainExcess strain = strain_excess(cloth);
  return {.truncated = truncated,
          .is_bearable = strain.is_bearable,
          .is_over_limit = strain.beyond_limit > strain_left_over};
}

// What was truncated is taken from the velocity, as far as there is any in that direction: a
// repulsion or correction that did not get through must not throw a particle the other way.
int TimeStep::truncate(GatedMotion& motion, Cloth& cloth) {
  const StageTimer timer(clock_, StepStage::truncation);
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

// while ∃ edge penetration: apply error recovery schemes.
StepReport TimeStep::recover(Bodies& bodies, Cloth& cloth) {
  const StageTimer timer(clock_, StepStage::recovery);
  const RecoveryReport report = ribbon::recover(bodies, recovery_, cloth.positions);
  return {.recovery_iterations = report.iterations,
          .penetrating_edges = report.penetrating_edges,
          .is_over_limit = published_correction_.any_over_limit(cloth.positions)};
}

double TimeStep::guaranteed_strain() const {
  return contact_ == ContactMethod::gate ? paper_strain_limit : 0;
}

StrainExcess TimeStep::strain_excess(const Cloth& cloth) {
  const StageTimer timer(clock_, StepStage::strain_correction);
  return strain_constraints_.excess(cloth.positions);
}

bool TimeStep::is_within_limit(const Cloth& cloth) {
  return strain_excess(cloth).is_bearable;
}

// ---- Before the first step

StepReport TimeStep::correct(const Matrix3Xd& before, Bodies& bodies, Cloth& cloth) {
  if (contact_ == ContactMethod::paper) return correct_as_published(before, bodies, cloth);
  GatedMotion motion(gate_, before, step_s_, bodies, clock_);
  motion.detect(before, cloth.positions);
  find_contacts(motion, cloth.positions, bodies);
  correct_strain_and_contact(strain_correction_.most_sweeps, before, bodies, cloth);
  return correct_with_gate(motion, bodies, cloth);
}

void TimeStep::move(const Matrix3Xd& target, Bodies& bodies, Cloth& cloth) {
  const Matrix3Xd before = cloth.positions;
  cloth.positions = target;
  correct(before, bodies, cloth);
  cloth.velocities.setZero();
}

StepReport TimeStep::settle(int rounds, Bodies& bodies, Cloth& cloth) {
  StepReport last{.is_over_limit = true};
  for (int round = 0; round < rounds && last.is_over_limit; ++round) {
    const Matrix3Xd before = cloth.positions;
    const int recovery_iterations = last.recovery_iterations;
    last = correct(before, bodies, cloth);
    last.recovery_iterations += recovery_iterations;
  }
  cloth.velocities.setZero();
  return last;
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

PairDistances pair_distances(const Scene& scene, const RestSize& size,
                             const ContactLengths& lengths) {
  if (scene.contact != ContactMethod::paper) return {size, lengths};
  return {size,
          {.activation_m = 0.1 * size.shortest_edge_m(), .thickness_m = scene.ribbon.thickness_m}};
}

}  // namespace

TimeStep::TimeStep(const Scene& scene, const RestSize& size, const ContactLengths& lengths,
                   double particle_mass_kg)
    : contact_(scene.contact),
      step_s_(scene.time.step_s),
      integrator_(
          suitable_integrator(scene.time, scene.contact, spring_network(size, scene.springs),
                              {scene.time.step_s, particle_mass_kg, scene.air_resistance_per_s,
                               scene.gravity_m_s2, scene.time.tolerance, lightness(size)})),
      distances_(pair_distances(scene, size, lengths)),
      repulsion_{.friction = scene.friction},
      strain_correction_(scene.strain_correction),
      strain_constraints_(strain_constraints(scene, size, lengths.rounding_m)),
      loose_rows_(size,
                  aimed_strain(scene.strain_correction.strain, size.along_m(), lengths.rounding_m)),
      activity_(strain_constraints_.activity()),
      contacts_(lightness(size)),
      gate_(size, distances_),
      published_correction_(size, paper_strain_limit),
      recovery_(RecoverySettings::of_edge(size.shortest_edge_m())) {}

}  // namespace ribbon
