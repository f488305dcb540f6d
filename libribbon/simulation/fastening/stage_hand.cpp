#include "simulation/fastening/stage_hand.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "geometry/vectors.h"
#include "ribbon_mesh/carry_way.h"
#include "simulation/fastening/hanging_weight.h"

namespace ribbon {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

namespace {

constexpr double felt_widths = 2;  // to either side of what the hand has

// How far a part may lag behind, over speed^2 / acceleration: half of the way on which all of the
// hand's strength brings it to the speed at which it is carried.
constexpr double of_gathering_speed = 0.25;
// And over speed, but a step at least: the more often a place could wait for the springs' ripples,
// the longer the same way would take in shorter steps.
constexpr double may_lag_s = 0.01;
// It has arrived where so short a way at that speed is left, but a quarter of the width at most,
// for hands may be strong; and where at its own speed that way would take it longer than so.
constexpr double arrived_within_s = 0.01;
constexpr double arrived_within_widths = 0.25;
constexpr double hardly_moves_s = 0.05;

HeldRows felt_rows(const HeldRows& held, const RestSize& size) {
  const double reach = std::ceil(felt_widths * size.width_m / size.along_m());
  const int rows = static_cast<int>(std::min<double>(size.grid.along, reach));
  return {std::max(0, held.first - rows), std::min(size.grid.along - 1, held.last + rows)};
}

}  // namespace

StageHand::StageHand(const HandScene& hand, const HeldRows& rows, const Scene& scene,
                     const RestSize& size, double particle_mass_kg, const Matrix3Xd& begun)
    : hand_(hand),
      fastening_(*scene.fastening),
      grid_(size.grid),
      rows_(rows),
      newton_per_m_s_(particle_mass_kg * scene.air_resistance_per_s),
      draws_(0.5 * size.grid.along / size.mean_rows(rows_.first, rows_.last)),
      weights_(Eigen::ArrayXd::Ones(Eigen::Index{rows_.count()} * size.grid.across)),
      air_per_s_(scene.air_resistance_per_s),
      step_s_(scene.time.step_s),
      arrived_m_(
          std::min(arrived_within_s * carrying_m_s(), arrived_within_widths * size.width_m)) {
  assert(rows.count() > 0 && "the scene's rules see to it");
  if (const Eigen::ArrayXd light = lightness(size); light.size() > 0)
    weights_ = light.segment(grid_.particle(rows_.first, 0), weights_.size()).inverse();
  if (hand.yield_strain.value_or(unyielding) < unyielding)
    yielding_.emplace(size, *hand.yield_strain, hanging_weight(scene, size, particle_mass_kg),
                      felt_rows(rows_, size));
  if (hand.task == HandTask::carry)
    carried_.emplace(middle(begun), carry_way(scene.curve, hand.carry));
}

// Of all that it has.
Vector3d StageHand::middle(const Matrix3Xd& of_particles) const {
  const int first = grid_.particle(rows_.first, 0);
  return mean_of_columns(of_particles.middleCols(first, rows_.count() * grid_.across));
}

// None where it is to pull away from the axis and lies on it.
Vector3d StageHand::direction(const Cloth& cloth) const {
  if (hand_.task == HandTask::pull) return hand_.direction;
  const Vector3d from_point = middle(cloth.positions) - fastening_.axis_point_m;
  return normalised(
      (from_point - dot(from_point, fastening_.axis_direction) * fastening_.axis_direction).eval());
}

double StageHand::strength_m_s2() const {
  return air_per_s_ * draws_ * hand_.speed_m_s;
}

double StageHand::carrying_m_s() const {
  return std::min(hand_.speed_m_s, fastening_.max_speed_m_s.value_or(hand_.speed_m_s));
}

Grip StageHand::grip(const Cloth& cloth, const Workplace& place) {
  const int first = grid_.particle(rows_.first, 0);
  const double* begun = place.begun.col(first).data();
  Grip grip{.first = first,
            .weights = {weights_.data(), static_cast<std::size_t>(weights_.size())},
            .places = carried_ ? Grip::Places(carried_to_.data(), 3, 1)
                               : Grip::Places(begun, 3, weights_.size())};
  grip.most_m_s2 = place.bearable * strength_m_s2();
  if (fastening_.max_speed_m_s) grip.most_m_s = *fastening_.max_speed_m_s;
  if (!carried_) return grip;
  carried_to_ = carried_->now();
  const Vector3d lag_m = middle(cloth.positions) - carried_to_;
  const double speed_m_s = carrying_m_s();
  const double most_lag_m =
      speed_m_s * (std::max(step_s_, may_lag_s) + speed_m_s / strength_m_s2() * of_gathering_speed);
  goes_on_m_ = length_of(lag_m) > most_lag_m ? 0 : speed_m_s * step_s_;
  grip.drift_m_s = (carried_->after(goes_on_m_) - carried_to_) / step_s_;
  return grip;
}

void StageHand::follow(const Cloth& cloth) {
  if (!carried_) return;
  carried_->go_on(goes_on_m_);
  const Vector3d lag_m = middle(cloth.positions) - carried_->now();
  has_arrived_ = carried_->has_arrived() && length_of(lag_m) < arrived_m_ &&
                 hardly_moves_s * length_of(middle(cloth.velocities)) < arrived_m_;
}

double StageHand::pull(const Cloth& cloth, const Workplace& place, Matrix3Xd& force,
                       Matrix3Xd& command) {
  assert(pulls());
  const double fraction = yielding_ ? yielding_->force_fraction(cloth.positions) : 1;
  const bool is_along = hand_.task == HandTask::pull_along;
  const Vector3d velocity =
      is_along ? Vector3d::Zero() : Vector3d(hand_.speed_m_s * direction(cloth));
  const double newton_per_m_s = is_along ? newton_per_m_s_ : newton_per_m_s_ * draws_;
  const int end = grid_.particle(rows_.last + 1, 0);
  for (int particle = grid_.particle(rows_.first, 0); particle < end; ++particle) {
    const Vector3d wanted_m_s =
        is_along ? Vector3d(hand_.speed_m_s / fastening_.speed_m_s * place.along.col(particle))
                 : velocity;
    command.col(particle) = place.bearable * wanted_m_s;
    force.col(particle) = fraction * newton_per_m_s * command.col(particle);
  }
  return place.bearable * fraction;
}

void StageHand::visit_state(StateArchive& archive) {
  auto& [hand, fastening, grid, rows, newton_per_m_s, draws, weights, air, step, arrived_within,
         yielding, carried, carried_to_in_step, goes_on_in_step, has_arrived] = *this;
  carried->visit_state(archive);
  archive.visit(has_arrived);
  has_arrived = has_arrived && carried->has_arrived();  // at the end of another way
}

}  // namespace ribbon
