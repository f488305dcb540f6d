#include <algorithm>
#include <cmath>

#include "simulation/integrator.h"
#include "simulation/spring_force.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

// Runge-Kutta stays stable up to |eigenvalue| * step = 2 sqrt 2 on the imaginary and 2.785 on the
// real axis; the margin covers what lies between.
constexpr double stability_limit = 2.5;

int stable_substeps(const SpringNetwork& springs, const MotionProperties& properties) {
  const double fastest =
      fastest_frequency(springs, properties.particle_count, properties.particle_mass_kg) +
      properties.air_resistance_per_s;
  // Beyond the largest number that fits no step would come to its end anyway.
  constexpr double most = 1e9;
  return static_cast<int>(
      std::clamp(std::ceil(fastest * properties.step_s / stability_limit), 1.0, most));
}

class RungeKutta final : public Integrator {
 public:
  RungeKutta(const SpringNetwork& springs, const MotionProperties& properties)
      : springs_(springs),
        properties_(properties),
        substeps_(stable_substeps(springs, properties)) {}

  void displace(const Matrix3Xd& fastening_force, Cloth& cloth) override {
    for (int substep = 0; substep < substeps_; ++substep) advance(fastening_force, cloth);
  }

  [[nodiscard]] int substeps() const override { return substeps_; }

 private:
  [[nodiscard]] Matrix3Xd acceleration(const Matrix3Xd& fastening_force, const Matrix3Xd& x,
                                       const Matrix3Xd& v) const {
    Matrix3Xd force = fastening_force.cols() > 0
                          ? fastening_force
                          : Matrix3Xd::Zero(3, properties_.particle_count).eval();
    add_spring_forces(springs_, x, force);
    return force / properties_.particle_mass_kg - properties_.air_resistance_per_s * v;
  }

  void advance(const Matrix3Xd& fastening_force, Cloth& cloth) const {
    const double h = properties_.step_s / substeps_;
    auto position = cloth.positions.leftCols(cloth.particle_count());
    Matrix3Xd& velocity = cloth.velocities;
    const Matrix3Xd a1 = acceleration(fastening_force, position, velocity);
    const Matrix3Xd v2 = velocity + h / 2 * a1;
    const Matrix3Xd a2 = acceleration(fastening_force, position + h / 2 * velocity, v2);
    const Matrix3Xd v3 = velocity + h / 2 * a2;
    const Matrix3Xd a3 = acceleration(fastening_force, position + h / 2 * v2, v3);
    const Matrix3Xd v4 = velocity + h * a3;
    const Matrix3Xd a4 = acceleration(fastening_force, position + h * v3, v4);
    position += h / 6 * (velocity + 2 * v2 + 2 * v3 + v4);
    velocity += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }

  SpringNetwork springs_;
  MotionProperties properties_;
  int substeps_;
};

}  // namespace

std::unique_ptr<Integrator> runge_kutta(const SpringNetwork& springs,
                                        const MotionProperties& properties) {
  return std::make_unique<RungeKutta>(springs, properties);
}

}  // namespace ribbon
