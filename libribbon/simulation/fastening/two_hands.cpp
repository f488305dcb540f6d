#include "simulation/fastening/two_hands.h"

#include <limits>

#include "simulation/fastening/hanging_weight.h"

namespace ribbon {

using Eigen::Matrix3Xd;

TwoHands::TwoHands(const Scene& scene, const RestSize& size, const Cloth& cloth)
    : force_(*scene.fastening, scene.air_resistance_per_s, size, cloth.positions,
             cloth.particle_mass_kg),
      progress_(size.grid, halves(size.grid), scene.time.step_s, scene.air_resistance_per_s),
      highest_m_s_(scene.fastening->max_speed_m_s.value_or(std::numeric_limits<double>::max())),
      eased_(scene.time.step_s) {
  if (scene.fastening->yield_strain < unyielding)
    yielding_.emplace(size, scene.fastening->yield_strain,
                      hanging_weight(scene, size, cloth.particle_mass_kg));
  if (scene.fastening->max_speed_m_s)
    speed_limit_.emplace(*scene.fastening->max_speed_m_s, cloth.particle_mass_kg,
                         scene.air_resistance_per_s, scene.time.step_s);
}

const Matrix3Xd& TwoHands::pull(const Cloth& cloth) {
  before_ = cloth.positions;
  pull_ = eased_.bearable() * force_.at(cloth.positions);
  command_ = pull_ / force_.newton_per_m_s();
  limit_speeds(highest_m_s_, command_);
  force_fraction_ = eased_.bearable();
  if (yielding_) {
    const double fraction = yielding_->force_fraction(cloth.positions);
    pull_ *= fraction;
    force_fraction_ *= fraction;
  }
  if (speed_limit_) speed_limit_->apply(cloth.velocities, pull_);
  return pull_;
}

void TwoHands::follow(const Cloth& cloth) {
  progress_.add(command_, before_, cloth.positions);
  eased_.pull_more();
}

void TwoHands::visit_state(StateArchive& archive) {
  auto& [force, yielding, speed_limit, progress, highest, eased, force_fraction, pull_of_step,
         command_of_step, before_step] = *this;
  force.visit_state(archive);
  eased.visit_state(archive);
  archive.visit(force_fraction);
  progress.visit_state(archive);
}

}  // namespace ribbon
