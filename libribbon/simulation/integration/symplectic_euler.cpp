#include "simulation/integration/integrator.h"
#include "simulation/integration/particle_runs.h"

namespace ribbon {

namespace {

using Eigen::MatrixX3d;

// Stable up to z = frequency * step = 2, and up to its root where damping may stop the fastest
// swing of all at once: of a displacement, 1 - z^2 is left then. The margin keeps the energy of a
// swing, which seems to vary by a factor of (2 + z) / (2 - z), to one of 4.8.
constexpr double symplectic_stability_limit = 1.3;

class SymplecticEuler final : public Integrator {
 public:
  // The air's resistance does not count: it is taken at the end of each substep, where it can only
  // slow the motion down.
  SymplecticEuler(const SpringNetwork& springs, const MotionProperties& properties)
      : Integrator(springs, properties,
                   fastest_frequency(springs, properties.particle_mass_kg, properties.lightness),
                   symplectic_stability_limit) {}

  [[nodiscard]] IntegrationMethod method() const override {
    return IntegrationMethod::symplectic_euler;
  }

 private:
  // v' = v + h (F(x) / m - c v'), then x' = x + h v'.
  void advance(double h) override {
    const double slowed = 1 / (1 + h * properties_.air_resistance_per_s);
    spring_forces_on_mean(state_.positions, forces_);
    for_each_particle_run(state_.positions.rows(), [&](Eigen::Index first, Eigen::Index count) {
      for (int axis = 0; axis < 3; ++axis) {
        auto velocities = state_.velocities.col(axis).segment(first, count);
        velocities += h / properties_.particle_mass_kg * forces_.col(axis).segment(first, count);
        if (state_.accelerations.rows() > 0)
          velocities += h * state_.accelerations.col(axis).segment(first, count);
        velocities *= slowed;
        state_.positions.col(axis).segment(first, count) += h * velocities;
      }
    });
    holding_.correct(slowed, state_.positions, state_.velocities);
  }

  MatrixX3d forces_;
};

}  // namespace

std::unique_ptr<Integrator> symplectic_euler(const SpringNetwork& springs,
                                             const MotionProperties& properties) {
  return std::make_unique<SymplecticEuler>(springs, properties);
}

}  // namespace ribbon
