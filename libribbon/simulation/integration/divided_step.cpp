#include "simulation/integration/divided_step.h"

#include <algorithm>
#include <cmath>

namespace ribbon {

DividedStep::DividedStep(const SpringNetwork& springs, const MotionProperties& properties,
                         double fastest_rad_s, double stability_limit)
    : springs_(springs, properties.grid.particle_count()), properties_(properties) {
  // Beyond the largest number that fits no step would come to its end anyway.
  constexpr double most = 1e9;
  substeps_ = static_cast<int>(
      std::clamp(std::ceil(fastest_rad_s * properties.step_s / stability_limit), 1.0, most));
}

void DividedStep::displace(const Eigen::Matrix3Xd& fastening_force, Cloth& cloth) {
  state_.take(fastening_force, cloth);
  for (int substep = 0; substep < substeps_; ++substep) advance(properties_.step_s / substeps_);
  state_.give(cloth);
}

}  // namespace ribbon
