#include "simulation/integration/integrator.h"

namespace ribbon {

namespace {

using Eigen::MatrixX3d;

// Runge-Kutta stays stable up to |eigenvalue| * step = 2 sqrt 2 on the imaginary and 2.785 on the
// real axis; the margin covers what lies between.
constexpr double runge_kutta_stability_limit = 2.5;

class RungeKutta final : public Integrator {
 public:
  RungeKutta(const SpringNetwork& springs, const MotionProperties& properties)
      : Integrator(springs, properties,
                   fastest_frequency(springs, properties.particle_mass_kg, properties.lightness) +
                       properties.air_resistance_per_s,
                   runge_kutta_stability_limit) {}

  [[nodiscard]] IntegrationMethod method() const override { return IntegrationMethod::rk4; }

 private:
  // Of one stage, from positions x and velocities v.
  void accelerate(const MatrixX3d& x, const MatrixX3d& v, MatrixX3d& a) {
    spring_forces_on_mean(x, a);
    a = a / properties_.particle_mass_kg - properties_.air_resistance_per_s * v;
    if (state_.accelerations.rows() > 0) a += state_.accelerations;
  }

  void advance(double h) override {
    MatrixX3d& x = state_.positions;
    MatrixX3d& v = state_.velocities;
    accelerate(x, v, a_);
    stage_x_ = x + h / 2 * v;
    stage_v_ = v + h / 2 * a_;
    sum_v_ = v + 2 * stage_v_;
    sum_a_ = a_;
    accelerate(stage_x_, stage_v_, a_);
    stage_x_ = x + h / 2 * stage_v_;
    stage_v_ = v + h / 2 * a_;
    sum_v_ += 2 * stage_v_;
    sum_a_ += 2 * a_;
    accelerate(stage_x_, stage_v_, a_);
    stage_x_ = x + h * stage_v_;
    stage_v_ = v + h * a_;
    sum_v_ += stage_v_;
    sum_a_ += 2 * a_;
    accelerate(stage_x_, stage_v_, a_);
    x += h / 6 * sum_v_;
    v += h / 6 * (sum_a_ + a_);
    const double z = h * properties_.air_resistance_per_s;
    holding_.correct(1 - z / 2 + z * z / 6 - z * z * z / 24, x, v);
  }

  MatrixX3d a_, stage_x_, stage_v_, sum_v_, sum_a_;
};

}  // namespace

std::unique_ptr<Integrator> runge_kutta(const SpringNetwork& springs,
                                        const MotionProperties& properties) {
  return std::make_unique<RungeKutta>(springs, properties);
}

}  // namespace ribbon
