// The internal friction of the springs, by which a ribbon comes to rest. The paper has none.
#pragma once

#include <Eigen/Core>

#include "ribbon_mesh/springs.h"

namespace ribbon {

// Each spring slows the speed at which its ends part or approach, as a dashpot beside it does. With
// r = 2 damping sqrt(2 stiffness / mass) h the speed becomes 1 / (1 + r) of what it was (backward
// Euler of that pair alone), one spring after the other (Shardlow, "Splitting for dissipative
// particle dynamics", 2003): stable for any springs and any h, while momentum and angular momentum
// stay and kinetic energy never grows. A network of equal stiffness over mass is damped alike in
// time, however fine it is.
class SpringDamping {
 public:
  // damping: a fraction of the critical one, > 0.
  SpringDamping(const SpringNetwork& network, double particle_mass_kg)
      : network_(network), particle_mass_kg_(particle_mass_kg) {}

  // What it does to the velocities in h seconds. particles x 3 each, m and m/s.
  void apply(double h, const Eigen::MatrixX3d& positions, Eigen::MatrixX3d& velocities) const;

 private:
  SpringNetwork network_;
  double particle_mass_kg_;
};

}  // namespace ribbon
