// Acceleration, velocity and displacement (paper, section 5.3).
#pragma once

#include <Eigen/Core>
#include <memory>

#include "geometry/ribbon_grid.h"
#include "ribbon_mesh/springs.h"
#include "scene/scene.h"
#include "simulation/state/cloth.h"

namespace ribbon {

// What an integrator needs to know besides the springs.
struct MotionProperties {
  double step_s = 0;
  RibbonGrid grid;
  double particle_mass_kg = 0;
  double air_resistance_per_s = 0;  // deceleration per speed
  // Of the implicit scheme, above 0: the minimum is found when the energy that is left to win is
  // less than this squared of what it takes to change the velocities so far. Too large: forces act
  // late and motion is damped; too small: each step takes more iterations.
  double tolerance = 0.1;
};

// Moves a ribbon by its springs, the air and the fastening force, one step at a time.
class Integrator {
 public:
  virtual ~Integrator() = default;

  // Moves the particles of the cloth by one step. The fastening force (3 x particles, N, or no
  // columns for none) is held over the step.
  virtual void displace(const Eigen::Matrix3Xd& fastening_force, Cloth& cloth) = 0;

  // Into how many parts it divides a step to stay stable on its springs and in its air, however the
  // ribbon lies.
  [[nodiscard]] virtual int substeps() const = 0;
};

// The one that the scene asks for.
std::unique_ptr<Integrator> create_integrator(IntegrationMethod method,
                                              const SpringNetwork& springs,
                                              const MotionProperties& properties);

// Fourth-order Runge-Kutta, as in the paper.
std::unique_ptr<Integrator> runge_kutta(const SpringNetwork& springs,
                                        const MotionProperties& properties);

// Symplectic Euler: one evaluation of the springs a part; energy is kept on average, but swings are
// distorted as soon as they are fast for the step.
std::unique_ptr<Integrator> symplectic_euler(const SpringNetwork& springs,
                                             const MotionProperties& properties);

// Backward Euler, stable on any springs without dividing a step: what is fast for the step is
// damped. The energy of free motion never grows.
std::unique_ptr<Integrator> implicit_euler(const SpringNetwork& springs,
                                           const MotionProperties& properties);

}  // namespace ribbon
