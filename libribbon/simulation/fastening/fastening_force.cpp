#include "simulation/fastening/fastening_force.h"

#include <algorithm>

#include "simulation/state/smoothed_directions.h"

namespace ribbon {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

FasteningForce::FasteningForce(const FasteningScene& scene, double air_resistance_per_s,
                               const RibbonGrid& grid, const Matrix3Xd& start,
                               double particle_mass_kg)
    : pull_(scene.pull),
      grid_(grid),
      axis_point_m_(scene.axis_point_m),
      axis_direction_(scene.axis_direction),
      held_rows_(std::min(grid.across, grid.along / 2)),
      newton_per_m_s_(particle_mass_kg * air_resistance_per_s),
      speed_m_s_(scene.speed_m_s) {
  if (pull_ == FasteningPull::ends) newton_per_m_s_ *= 0.5 * grid.along / held_rows_;
  for (int particle = 0; particle < grid.particle_count(); ++particle)
    mean_distance_m_ += distance_from_axis_m(start.col(particle)) / grid.particle_count();
}

void FasteningForce::visit_state(StateArchive& archive) {
  auto& [pull, grid, axis_point, axis_direction, held_rows, newton, speed, mean_distance] = *this;
  archive.visit(mean_distance);
}

// A ribbon that lies on the axis has no distance to be proportional to, and no force.
double FasteningForce::newton_per_m() const {
  return mean_distance_m_ > 0 ? newton_per_m_s_ * speed_m_s_ / mean_distance_m_ : 0;
}

double FasteningForce::distance_from_axis_m(const Vector3d& position) const {
  const Vector3d from_point = position - axis_point_m_;
  return (from_point - from_point.dot(axis_direction_) * axis_direction_).norm();
}

double FasteningForce::strength_n(int particle, const Vector3d& position) const {
  if (pull_ == FasteningPull::distributed) return newton_per_m() * distance_from_axis_m(position);
  const int row = grid_.row(particle);
  return std::min(row, grid_.along - 1 - row) < held_rows_ ? newton_per_m_s_ * speed_m_s_ : 0;
}

Matrix3Xd FasteningForce::at(const Matrix3Xd& positions) const {
  Matrix3Xd forces = smoothed_directions_along(grid_, positions);
  for (int particle = 0; particle < grid_.particle_count(); ++particle) {
    const int twice_from_middle = 2 * grid_.row(particle) - (grid_.along - 1);
    const double sign = twice_from_middle > 0 ? 1 : twice_from_middle < 0 ? -1 : 0;
    forces.col(particle) *= sign * strength_n(particle, positions.col(particle));
  }
  return forces;
}

}  // namespace ribbon
