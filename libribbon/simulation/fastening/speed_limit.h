// Hands do not pull what already moves fast enough.
#pragma once

#include <Eigen/Core>

namespace ribbon {

class SpeedLimit {
 public:
  // highest_m_s, particle_mass_kg and step_s > 0; air_resistance_per_s > 0 is what the force works
  // against.
  SpeedLimit(double highest_m_s, double particle_mass_kg, double air_resistance_per_s,
             double step_s);

  // Scales each force (3 x particles, N) down, so that over a step it brings a free particle of
  // that velocity (3 x particles, m/s) to no more than the limit along the force; to nothing where
  // the particle is so fast that air alone does not slow it down enough.
  void apply(const Eigen::Matrix3Xd& velocities, Eigen::Matrix3Xd& forces) const;

 private:
  double highest_m_s_;
  double kept_;               // the fraction of its speed that the air leaves a particle in a step
  double newton_per_gained_;  // force that makes a particle gain 1 m/s in a step
};

// Shortens velocities (3 x particles, m/s) that are beyond the highest.
void limit_speeds(double highest_m_s, Eigen::Matrix3Xd& velocities);

}  // namespace ribbon
