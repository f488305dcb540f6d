// Acceleration, velocity and displacement (paper, section 5.3).
#pragma once

#include <Eigen/Core>

#include "ribbon_mesh/springs.h"
#include "simulation/cloth.h"

namespace ribbon {

// How many equal parts a step must be divided into so that fourth-order Runge-Kutta stays stable on
// these springs and this air resistance, however the ribbon lies.
int stable_substeps(const SpringNetwork& network, int particle_count, double particle_mass_kg,
                    double air_resistance_per_s, double step_s);

// Moves the cloth by `step_s` with fourth-order Runge-Kutta in `substeps` parts. The fastening
// force (3 x particles, N, or no columns for none) is held over the step; springs and air
// resistance are evaluated anew in each stage.
void integrate(const SpringNetwork& network, const Eigen::Matrix3Xd& fastening_force,
               double air_resistance_per_s, double step_s, int substeps, Cloth& cloth);

}  // namespace ribbon
