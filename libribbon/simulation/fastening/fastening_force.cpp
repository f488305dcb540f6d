#include "simulation/fastening/fastening_force.h"

#include <algorithm>

#include "geometry/vectors.h"

namespace ribbon {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

FasteningForce::FasteningForce(const FasteningScene& scene, double air_resistance_per_s,
                               const RestSize& size, const Matrix3Xd& start,
                               double particle_mass_kg)
    : scene_(scene),
      grid_(size.grid),
      held_rows_(std::min(grid_.across, grid_.along / 2)),
      newton_per_m_s_(particle_mass_kg * air_resistance_per_s),
      tangents_(grid_) {
  if (scene.pull == FasteningPull::ends) newton_per_m_s_ *= 0.5 * grid_.along / held_rows_;
  const int pulled = scene.pull == FasteningPull::ends ? held_rows_ : grid_.along / 2;
  weakened_ = {pulled / size.mean_rows(0, pulled - 1),
               pulled / size.mean_rows(grid_.along - pulled, grid_.along - 1)};
  for (int particle = 0; particle < grid_.particle_count(); ++particle)
    mean_distance_m_ += distance_from_axis_m(start.col(particle)) / grid_.particle_count();
}

void FasteningForce::visit_state(StateArchive& archive) {
  auto& [scene, grid, held_rows, newton, weakened, mean_distance, tangents, forces] = *this;
  archive.visit(mean_distance);
}

double FasteningForce::distance_from_axis_m(const Vector3d& position) const {
  const Vector3d from_point = position - scene_.axis_point_m;
  return length_of(from_point - dot(from_point, scene_.axis_direction) * scene_.axis_direction);
}

double FasteningForce::strength_n(int particle, const Vector3d& position) const {
  const int row = grid_.row(particle);
  const double full_n = newton_per_m_s_ * scene_.speed_m_s;
  if (scene_.pull == FasteningPull::ends)
    return std::min(row, grid_.along - 1 - row) < held_rows_ ? full_n : 0;
  // A ribbon that lies on the axis has no distance to be proportional to, and no force.
  return mean_distance_m_ > 0 ? full_n / mean_distance_m_ * distance_from_axis_m(position) : 0;
}

const Matrix3Xd& FasteningForce::at(const Matrix3Xd& positions) {
  forces_ = tangents_.at(positions);
  for (int particle = 0; particle < grid_.particle_count(); ++particle) {
    const int twice_from_middle = 2 * grid_.row(particle) - (grid_.along - 1);
    const double sign = twice_from_middle > 0   ? weakened_[1]
                        : twice_from_middle < 0 ? -weakened_[0]
                                                : 0;
    forces_.col(particle) *= sign * strength_n(particle, positions.col(particle));
  }
  return forces_;
}

}  // namespace ribbon
