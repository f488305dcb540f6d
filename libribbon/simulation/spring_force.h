// The resistance of the springs (paper, section 5.1).
#pragma once

#include <Eigen/Core>

#include "ribbon_mesh/springs.h"

namespace ribbon {

// Adds the force of every spring to both its particles: resistance times elongation, along the
// spring. positions: 3 x at least all particles; forces: 3 x particles, N.
void add_spring_forces(const SpringNetwork& network, const Eigen::Matrix3Xd& positions,
                       Eigen::Matrix3Xd& forces);

// The largest |length / rest length - 1| of the stretch and shear springs; 0 without any.
double worst_strain(const SpringNetwork& network, const Eigen::Matrix3Xd& positions);

// An upper bound of the fastest angular frequency (rad/s) at which any particle can swing on its
// springs, however the ribbon lies.
double fastest_frequency(const SpringNetwork& network, int particle_count, double particle_mass_kg);

}  // namespace ribbon
