#include "simulation/repulsion.h"

namespace ribbon {

using Eigen::Vector3d;

void repel(const FeaturePair& pair, const Collision& collision, double gap_m, double restitution,
           Cloth& cloth) {
  double mobility = 0;  // how far the contact points part per unit of impulse between them
  double distance_m = 0;
  double speed_m_s = 0;  // positive: parting
  for (int k = 0; k < 4; ++k) {
    const int vertex = pair.vertices[static_cast<std::size_t>(k)];
    const double weight = collision.weights[k];
    mobility += weight * weight * cloth.inverse_mass(vertex);
    distance_m += weight * collision.normal.dot(cloth.positions.col(vertex));
    if (vertex < cloth.particle_count())
      speed_m_s += weight * collision.normal.dot(cloth.velocities.col(vertex));
  }
  if (mobility == 0) return;
  const double push = distance_m < gap_m ? (gap_m - distance_m) / mobility : 0;
  const double impulse = speed_m_s < 0 ? -(1 + restitution) * speed_m_s / mobility : 0;
  for (int k = 0; k < 4; ++k) {
    const int vertex = pair.vertices[static_cast<std::size_t>(k)];
    if (vertex >= cloth.particle_count()) continue;
    const Vector3d share = collision.weights[k] * cloth.inverse_mass(vertex) * collision.normal;
    cloth.positions.col(vertex) += push * share;
    cloth.velocities.col(vertex) += impulse * share;
  }
}

}  // namespace ribbon
