#include <algorithm>
#include <cmath>

#include "simulation/flat_state.h"
#include "simulation/integrator.h"
#include "simulation/spring_force.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixX3d;

// Stable up to z = frequency * step = 2. The energy of a swing seems to vary by a factor of
// (2 + z) / (2 - z); the margin keeps that at 7.
constexpr double stability_limit = 1.5;

// The air's resistance does not count: it is taken at the end of each part, where it can only slow
// the motion down.
int stable_substeps(const SpringNetwork& springs, const MotionProperties& properties) {
  const double fastest =
      fastest_frequency(springs, properties.particle_count, properties.particle_mass_kg);
  // Beyond the largest number that fits no step would come to its end anyway.
  constexpr double most = 1e9;
  return static_cast<int>(
      std::clamp(std::ceil(fastest * properties.step_s / stability_limit), 1.0, most));
}

class SymplecticEuler final : public Integrator {
 public:
  SymplecticEuler(const SpringNetwork& springs, const MotionProperties& properties)
      : springs_(springs, properties.particle_count),
        properties_(properties),
        substeps_(stable_substeps(springs, properties)) {}

  void displace(const Matrix3Xd& fastening_force, Cloth& cloth) override {
    state_.take(fastening_force, cloth);
    for (int substep = 0; substep < substeps_; ++substep) advance();
    state_.give(cloth);
  }

  [[nodiscard]] int substeps() const override { return substeps_; }

 private:
  // v' = v + h (F(x) / m - c v'), then x' = x + h v'.
  void advance() {
    const double h = properties_.step_s / substeps_;
    const double slowed = 1 / (1 + h * properties_.air_resistance_per_s);
    springs_.forces(state_.positions, forces_);
    state_.velocities += h / properties_.particle_mass_kg * forces_;
    if (state_.pull.rows() > 0) state_.velocities += h * state_.pull;
    state_.velocities *= slowed;
    state_.positions += h * state_.velocities;
  }

  SpringForces springs_;
  MotionProperties properties_;
  int substeps_;
  FlatState state_;
  MatrixX3d forces_;
};

}  // namespace

std::unique_ptr<Integrator> symplectic_euler(const SpringNetwork& springs,
                                             const MotionProperties& properties) {
  return std::make_unique<SymplecticEuler>(springs, properties);
}

}  // namespace ribbon
