#include "simulation/fastening/speed_limit.h"

#include <algorithm>

#include "geometry/vectors.h"
#include "simulation/fastening/decay.h"

namespace ribbon {

// A free particle under a constant force: v' = F / m - air v.
SpeedLimit::SpeedLimit(double highest_m_s, double particle_mass_kg, double air_resistance_per_s,
                       double step_s)
    : highest_m_s_(highest_m_s),
      kept_(1 - decayed(air_resistance_per_s * step_s)),
      newton_per_gained_(particle_mass_kg * air_resistance_per_s /
                         decayed(air_resistance_per_s * step_s)) {}

void SpeedLimit::apply(const Eigen::Matrix3Xd& velocities, Eigen::Matrix3Xd& forces) const {
  for (Eigen::Index particle = 0; particle < forces.cols(); ++particle) {
    const double force_n = length_of(forces.col(particle));
    if (force_n == 0) continue;
    const double speed_m_s = dot(forces.col(particle), velocities.col(particle)) / force_n;
    const double most_n = newton_per_gained_ * std::max(0.0, highest_m_s_ - kept_ * speed_m_s);
    if (force_n > most_n) forces.col(particle) *= most_n / force_n;
  }
}

void limit_speeds(double highest_m_s, Eigen::Matrix3Xd& velocities) {
  for (auto velocity : velocities.colwise()) {
    const double speed_m_s = length_of(velocity);
    if (speed_m_s > highest_m_s) velocity *= highest_m_s / speed_m_s;
  }
}

}  // namespace ribbon
