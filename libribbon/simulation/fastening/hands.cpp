#include "simulation/fastening/hands.h"

#include <cmath>
#include <limits>

namespace ribbon {

using Eigen::Matrix3Xd;

namespace {

constexpr double standstill = 0.03;

// Forces as the speeds that they reach against the air.
Matrix3Xd commanded(const Matrix3Xd& forces, double newton_per_m_s, double highest_m_s) {
  Matrix3Xd command = forces / newton_per_m_s;
  for (auto velocity : command.colwise()) {
    const double speed_m_s = velocity.norm();
    if (speed_m_s > highest_m_s) velocity *= highest_m_s / speed_m_s;
  }
  return command;
}

}  // namespace

Hands::Hands(const Scene& scene, const RibbonGrid& grid, double length_m, const Cloth& cloth)
    : force_(*scene.fastening, scene.air_resistance_per_s, grid, cloth.positions,
             cloth.particle_mass_kg),
      progress_(grid, scene.time.step_s, scene.air_resistance_per_s),
      highest_m_s_(scene.fastening->max_speed_m_s.value_or(std::numeric_limits<double>::max())) {
  if (scene.fastening->yield_strain)
    yielding_.emplace(grid, length_m, *scene.fastening->yield_strain);
  if (scene.fastening->max_speed_m_s)
    speed_limit_.emplace(*scene.fastening->max_speed_m_s, cloth.particle_mass_kg,
                         scene.air_resistance_per_s, scene.time.step_s);
}

Matrix3Xd Hands::pull(const Cloth& cloth) {
  before_ = cloth.positions.leftCols(cloth.particle_count());
  Matrix3Xd force = force_.at(cloth.positions);
  command_ = commanded(force, force_.newton_per_m_s(), highest_m_s_);
  if (yielding_) share_ = yielding_->feel(cloth.positions);
  force *= share_;
  if (speed_limit_) speed_limit_->lower(cloth.velocities, force);
  return force;
}

void Hands::follow(const Cloth& cloth) {
  progress_.add(command_, before_, cloth.positions);
}

void Hands::visit_state(StateArchive& archive) {
  auto& [force, yielding, speed_limit, memory, highest, share, command_of_step, before_step] =
      *this;
  force.visit_state(archive);
  archive.visit(share);
  memory.visit_state(archive);
}

bool Hands::are_stopped() const {
  return progress_.knows_all() && std::abs(progress()) < standstill;
}

}  // namespace ribbon
