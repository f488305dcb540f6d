#include "simulation/fastening/hands.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/vectors.h"

namespace ribbon {

using Eigen::Matrix3Xd;

namespace {

constexpr double standstill = 0.03;
constexpr double least_pull = 1e-9;  // of the force
constexpr double more_pull = 1.05;   // in each step, up to all of it

void limit_speeds(double highest_m_s, Matrix3Xd& velocities) {
  for (auto velocity : velocities.colwise()) {
    const double speed_m_s = length_of(velocity);
    if (speed_m_s > highest_m_s) velocity *= highest_m_s / speed_m_s;
  }
}

std::optional<HangingWeight> hanging_weight(const Scene& scene, const RestSize& size,
                                            const Cloth& cloth) {
  if (!scene.gravity_m_s2) return std::nullopt;
  return HangingWeight(size, scene.springs, cloth.particle_mass_kg, *scene.gravity_m_s2);
}

}  // namespace

Hands::Hands(const Scene& scene, const RestSize& size, const Cloth& cloth)
    : force_(*scene.fastening, scene.air_resistance_per_s, size.grid, cloth.positions,
             cloth.particle_mass_kg),
      progress_(size.grid, scene.time.step_s, scene.air_resistance_per_s),
      highest_m_s_(scene.fastening->max_speed_m_s.value_or(std::numeric_limits<double>::max())) {
  if (scene.fastening->yield_strain)
    yielding_.emplace(size, *scene.fastening->yield_strain, hanging_weight(scene, size, cloth));
  if (scene.fastening->max_speed_m_s)
    speed_limit_.emplace(*scene.fastening->max_speed_m_s, cloth.particle_mass_kg,
                         scene.air_resistance_per_s, scene.time.step_s);
}

const Matrix3Xd& Hands::pull(const Cloth& cloth) {
  before_ = cloth.positions;
  pull_ = bearable_ * force_.at(cloth.positions);
  command_ = pull_ / force_.newton_per_m_s();
  limit_speeds(highest_m_s_, command_);
  force_fraction_ = bearable_;
  if (yielding_) {
    const double fraction = yielding_->force_fraction(cloth.positions);
    pull_ *= fraction;
    force_fraction_ *= fraction;
  }
  if (speed_limit_) speed_limit_->apply(cloth.velocities, pull_);
  return pull_;
}

void Hands::ease() {
  bearable_ = std::max(least_pull, bearable_ / 2);
}

void Hands::follow(const Cloth& cloth) {
  progress_.add(command_, before_, cloth.positions);
  bearable_ = std::min(1.0, more_pull * bearable_);
}

void Hands::visit_state(StateArchive& archive) {
  auto& [force, yielding, speed_limit, progress, highest, bearable, force_fraction, pull_of_step,
         command_of_step, before_step] = *this;
  force.visit_state(archive);
  archive.visit(bearable);
  archive.visit(force_fraction);
  progress.visit_state(archive);
}

bool Hands::are_stopped() const {
  return progress_.knows_all() && std::abs(progress()) < standstill;
}

}  // namespace ribbon
