// Where the vertices of features are, of the ribbon and of the obstacle alike.
#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace ribbon {

// Features number the particles of the ribbon from 0 on and the vertices of the obstacle after
// them. This looks a vertex up where it is kept, so that nobody copies the obstacle, which never
// moves.
class VertexPositions {
 public:
  // 3 x particles and 3 x vertices of the obstacle, which both must outlive this.
  VertexPositions(const Eigen::Matrix3Xd& particles, const Eigen::Matrix3Xd& obstacle)
      : particles_(particles.data()),
        obstacle_(obstacle.data()),
        particle_count_(static_cast<int>(particles.cols())) {}
  // Of a ribbon alone.
  // NOLINTNEXTLINE(google-explicit-constructor): a ribbon's positions are all that there is
  VertexPositions(const Eigen::Matrix3Xd& particles) : VertexPositions(particles, particles) {}

  [[nodiscard]] Eigen::Map<const Eigen::Vector3d> operator[](int vertex) const {
    const bool is_particle = vertex < particle_count_;
    const double* of_body = is_particle ? particles_ : obstacle_;
    return Eigen::Map<const Eigen::Vector3d>(
        of_body + std::ptrdiff_t{3} * (is_particle ? vertex : vertex - particle_count_));
  }

 private:
  const double* particles_;
  const double* obstacle_;
  int particle_count_;
};

}  // namespace ribbon
