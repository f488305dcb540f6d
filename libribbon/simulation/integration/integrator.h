// Acceleration, velocity and displacement (paper, section 5.3).
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>

#include "ribbon_mesh/springs.h"
#include "scene/scene.h"
#include "simulation/integration/holding.h"
#include "simulation/integration/internal_damping.h"
#include "simulation/integration/spring_forces.h"
#include "simulation/state/cloth.h"
#include "simulation/state/grip.h"

namespace ribbon {

// What an integrator needs to know besides the springs.
struct MotionProperties {
  double step_s = 0;
  double particle_mass_kg = 0;      // mean
  double air_resistance_per_s = 0;  // deceleration per speed
  std::optional<Eigen::Vector3d> gravity_m_s2 = std::nullopt;
  // Of the implicit scheme, above 0: the minimum is found when the energy that is left to win is
  // less than this squared of what it takes to change the velocities so far. Too large: forces act
  // late and motion is damped; too small: each step takes more iterations.
  double tolerance = 0.1;
  Eigen::ArrayXd lightness = {};  // as Cloth has it
};

// The particles as integrators compute with them: each axis a column of its own, so that springs
// are computed several at a time. Contact takes particles one by one, as Cloth has them.
struct MotionState {
  Eigen::MatrixX3d positions;      // particles x 3, m
  Eigen::MatrixX3d velocities;     // particles x 3, m/s
  Eigen::MatrixX3d accelerations;  // particles x 3, m/s^2, by the fastening force and gravity, or
                                   // no rows without either
};

// Moves a ribbon by its springs, the air, gravity and the fastening force.
class Integrator {
 public:
  virtual ~Integrator() = default;

  // Moves the particles of the cloth by one step. The fastening force (3 x particles, N, or no
  // columns for none) is held over the step. It is what a particle of mean mass gets; heavier ones
  // get more, in proportion.
  void displace(const Eigen::Matrix3Xd& fastening_force, Cloth& cloth);

  // Likewise in substeps() parts: first the force that is held over those that follow, with
  // gravity, and then each of them.
  void hold_force(const Eigen::Matrix3Xd& fastening_force, const Cloth& cloth);
  void displace_in_substep(Cloth& cloth);

  // From now on hands hold parts of the cloth so. What it refers to must outlive the next steps.
  void take_grips(std::span<const Grip> grips) { holding_.take(grips); }

  // From the next force on.
  void set_gravity(const std::optional<Eigen::Vector3d>& acceleration_m_s2) {
    properties_.gravity_m_s2 = acceleration_m_s2;
  }
  // From the next force on gravity and the springs count with that fraction (above 0, up to 1).
  void ease(double fraction) {
    gravity_fraction_ = fraction;
    springs_.slacken(fraction);
  }

  [[nodiscard]] virtual IntegrationMethod method() const = 0;

  // How far gravity leads from rest in that time: as far as by any of the schemes.
  [[nodiscard]] Eigen::Vector3d fall_m(double duration_s) const;

  // Into how many parts it divides a step: an explicit scheme as many as keep it stable on its
  // springs and in its air, however the ribbon lies; the implicit one as divide_steps() said last.
  [[nodiscard]] int substeps() const { return substeps_; }

  // Divides the steps that follow into so many parts, as far as stability leaves it the choice: the
  // implicit scheme alone, which begins with 1.
  virtual void divide_steps(int /*parts*/) {}

 protected:
  // With as many substeps as an explicit scheme needs that is stable while each of them, times
  // fastest_rad_s, is no more than stability_limit (> 0); of the implicit scheme one.
  Integrator(const SpringNetwork& springs, const MotionProperties& properties,
             double fastest_rad_s = 0, double stability_limit = 1);

  // Moves state_ by one substep, of h seconds, for which holding_ has begun.
  virtual void advance(double h) = 0;

  void set_substeps(int substeps) { substeps_ = substeps; }
  [[nodiscard]] double substep_s() const { return properties_.step_s / substeps_; }

  // Overwrites `forces` (particles x 3, N) with those that would accelerate particles of mean mass
  // as the springs do.
  void spring_forces_on_mean(const Eigen::MatrixX3d& positions, Eigen::MatrixX3d& forces);

  SpringForces springs_;
  MotionProperties properties_;
  MotionState state_;
  Holding holding_;

 private:
  int substeps_;
  double gravity_fraction_ = 1;
  std::optional<InternalDamping> damping_;
};

std::unique_ptr<Integrator> create_integrator(IntegrationMethod method,
                                              const SpringNetwork& springs,
                                              const MotionProperties& properties);

// Into how many parts an explicit scheme may divide a step. Where contact answers to each of them,
// more than most wait for; where it acts once a step, as published, far fewer: springs that swing
// many times between two contacts turn what contact strains into motion, without a bound.
int most_explicit_parts(IntegrationMethod method, ContactMethod contact,
                        const SpringNetwork& springs);

// The one that the scene names. Where it names none: the usual one or, where that may not divide a
// step into as many parts as it needs, the implicit one, if it takes so wide a ribbon.
std::unique_ptr<Integrator> suitable_integrator(const TimeScene& time, ContactMethod contact,
                                                const SpringNetwork& springs,
                                                const MotionProperties& properties);

// Fourth-order Runge-Kutta, as in the paper.
std::unique_ptr<Integrator> runge_kutta(const SpringNetwork& springs,
                                        const MotionProperties& properties);

// Symplectic Euler: one evaluation of the springs a substep; energy is kept on average, but swings
// are distorted as soon as they are fast for the step.
std::unique_ptr<Integrator> symplectic_euler(const SpringNetwork& springs,
                                             const MotionProperties& properties);

// The implicit scheme solves in as many modes across the ribbon, each over all of its width: what
// that takes grows with the square of the width.
inline constexpr int most_across_implicit = 500;  // particles

inline constexpr int most_implicit_parts = 8;  // of a step

// Backward Euler, stable on any springs without substeps: what is fast for the step, or for a part
// of it, is damped. The energy of free motion never grows. Of ribbons of at most
// most_across_implicit.
std::unique_ptr<Integrator> implicit_euler(const SpringNetwork& springs,
                                           const MotionProperties& properties);

}  // namespace ribbon
