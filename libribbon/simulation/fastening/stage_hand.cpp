#include "simulation/fastening/stage_hand.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <variant>

#include "geometry/vectors.h"
#include "ribbon_mesh/carry_way.h"
#include "simulation/fastening/hanging_weight.h"

namespace ribbon {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

namespace {

constexpr double felt_widths = 2;  // to either side of what the hand has
// Of a step, what a held particle is slower than. The force stands still during a step: beyond some
// 0.8 a held particle would swing up.
constexpr double hold_per_step = 0.5;

HeldRows felt_rows(const HeldRows& held, const RestSize& size) {
  const double reach = std::ceil(felt_widths * size.width_m / size.along_m());
  const int rows = static_cast<int>(std::min<double>(size.grid.along, reach));
  return {std::max(0, held.first - rows), std::min(size.grid.along - 1, held.last + rows)};
}

// No longer than that.
Vector3d shortened(Vector3d force_n, double most_n) {
  const double asked_n = length_of(force_n);
  if (asked_n > most_n) force_n *= most_n / asked_n;
  return force_n;
}

}  // namespace

StageHand::StageHand(const HandScene& hand, const Scene& scene, const RestSize& size,
                     double particle_mass_kg, const Matrix3Xd& begun)
    : hand_(hand),
      fastening_(*scene.fastening),
      grid_(size.grid),
      rows_(held_rows(std::get<Span>(hand.at), size.grid)),
      newton_per_m_s_(particle_mass_kg * scene.air_resistance_per_s),
      draws_(0.5 * size.grid.along / size.mean_rows(rows_.first, rows_.last)),
      hold_per_s_(hold_per_step / scene.time.step_s),
      air_per_s_(scene.air_resistance_per_s),
      step_s_(scene.time.step_s),
      particle_mass_kg_(particle_mass_kg) {
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

// Of each particle.
double StageHand::most_force_n() const {
  return newton_per_m_s_ * draws_ * hand_.speed_m_s;
}

// Of each particle, for what is off its place; critically damped, with what the air takes:
// x'' = -2 w x' - w^2 x.
Vector3d StageHand::wanted_force(const Vector3d& off_m, const Vector3d& velocity_m_s) const {
  const double damping_per_s = std::max(0.0, 2 * hold_per_s_ - air_per_s_);
  return -particle_mass_kg_ * (hold_per_s_ * hold_per_s_ * off_m + damping_per_s * velocity_m_s);
}

// Each particle goes back to its place.
void StageHand::hold(const Cloth& cloth, const Workplace& place, Matrix3Xd& force) const {
  const int end = grid_.particle(rows_.last + 1, 0);
  for (int particle = grid_.particle(rows_.first, 0); particle < end; ++particle)
    force.col(particle) =
        place.bearable *
        shortened(wanted_force(cloth.positions.col(particle) - place.begun.col(particle),
                               cloth.velocities.col(particle)),
                  most_force_n());
}

// All particles get the same force, so that the part is free to turn.
Vector3d StageHand::carrying_force(const Cloth& cloth) const {
  return wanted_force(middle(cloth.positions) - carried_->now(), middle(cloth.velocities));
}

void StageHand::follow(const Cloth& cloth) {
  if (carried_ && length_of(carrying_force(cloth)) <= most_force_n())
    carried_->go_on(hand_.speed_m_s * step_s_);
}

double StageHand::pull(const Cloth& cloth, const Workplace& place, Matrix3Xd& force,
                       Matrix3Xd& command) {
  if (hand_.task == HandTask::hold) {
    hold(cloth, place, force);
    return place.bearable;
  }
  if (carried_) {
    const Vector3d carrying_n = place.bearable * shortened(carrying_force(cloth), most_force_n());
    force.middleCols(grid_.particle(rows_.first, 0), rows_.count() * grid_.across).colwise() =
        carrying_n;
    return place.bearable;
  }
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
  if (carried_) carried_->visit_state(archive);
}

}  // namespace ribbon
