#include "simulation/integrate.h"

#include <algorithm>
#include <cmath>

#include "simulation/spring_force.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

// Runge-Kutta stays stable up to |eigenvalue| * step = 2 sqrt 2 on the imaginary and 2.785 on the
// real axis; the margin covers what lies between.
constexpr double stability_limit = 2.5;

}  // namespace

int stable_substeps(const SpringNetwork& network, int particle_count, double particle_mass_kg,
                    double air_resistance_per_s, double step_s) {
  const double fastest =
      fastest_frequency(network, particle_count, particle_mass_kg) + air_resistance_per_s;
  // Beyond the largest number that fits no step would come to its end anyway.
  constexpr double most = 1e9;
  return static_cast<int>(std::clamp(std::ceil(fastest * step_s / stability_limit), 1.0, most));
}

void integrate(const SpringNetwork& network, const Matrix3Xd& fastening_force,
               double air_resistance_per_s, double step_s, int substeps, Cloth& cloth) {
  const double h = step_s / substeps;
  auto position = cloth.positions.leftCols(cloth.particle_count());
  Matrix3Xd& velocity = cloth.velocities;

  const auto acceleration = [&](const Matrix3Xd& x, const Matrix3Xd& v) {
    Matrix3Xd force = fastening_force.cols() > 0
                          ? fastening_force
                          : Matrix3Xd::Zero(3, cloth.particle_count()).eval();
    add_spring_forces(network, x, force);
    return Matrix3Xd(force / cloth.particle_mass_kg - air_resistance_per_s * v);
  };

  for (int substep = 0; substep < substeps; ++substep) {
    const Matrix3Xd a1 = acceleration(position, velocity);
    const Matrix3Xd v2 = velocity + h / 2 * a1;
    const Matrix3Xd a2 = acceleration(position + h / 2 * velocity, v2);
    const Matrix3Xd v3 = velocity + h / 2 * a2;
    const Matrix3Xd a3 = acceleration(position + h / 2 * v2, v3);
    const Matrix3Xd v4 = velocity + h * a3;
    const Matrix3Xd a4 = acceleration(position + h * v3, v4);
    position += h / 6 * (velocity + 2 * v2 + 2 * v3 + v4);
    velocity += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
}

}  // namespace ribbon
