#include "simulation/contact/repulsion.h"

#include <algorithm>

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// The vector from the contact point of the second feature to that of the first, of any quantity
// that the particles have; the vertices beyond its columns have none.
Vector3d between_contact_points(const FeaturePair& pair, const Collision& collision,
                                const Eigen::Ref<const Matrix3Xd>& of_vertex) {
  Vector3d result = Vector3d::Zero();
  for (int k = 0; k < 4; ++k) {
    const int vertex = pair.vertices[static_cast<std::size_t>(k)];
    if (vertex < of_vertex.cols()) result += collision.weights[k] * of_vertex.col(vertex);
  }
  return result;
}

// How far the contact points part per unit of impulse between them.
double mobility_of(const FeaturePair& pair, const Collision& collision, const Cloth& cloth) {
  double mobility = 0;
  for (int k = 0; k < 4; ++k)
    mobility += collision.weights[k] * collision.weights[k] *
                cloth.inverse_mass(pair.vertices[static_cast<std::size_t>(k)]);
  return mobility;
}

// Coulomb: what is taken from `sliding` across the normal is at most `friction` times `pressed`.
Vector3d rubbed_off(const Vector3d& sliding, const Vector3d& normal, double friction,
                    double pressed) {
  const Vector3d across = sliding - normal.dot(sliding) * normal;
  const double length = across.norm();
  return length > 0 ? Vector3d(-std::min(1.0, friction * pressed / length) * across)
                    : Vector3d::Zero();
}

}  // namespace

void repel(const FeaturePair& pair, const Collision& collision, double gap_m,
           const RepulsionSettings& settings, const Matrix3Xd& before, Cloth& cloth) {
  const double mobility = mobility_of(pair, collision, cloth);
  if (mobility == 0) return;
  const Vector3d apart = between_contact_points(pair, collision, cloth.positions);
  const Vector3d velocity = between_contact_points(pair, collision, cloth.velocities);
  const double distance_m = collision.normal.dot(apart);
  const double speed_m_s = collision.normal.dot(velocity);  // positive: parting
  const double opened_m = std::max(0.0, gap_m - distance_m);
  const double gained_m_s = speed_m_s < 0 ? -(1 + settings.restitution) * speed_m_s : 0;
  Vector3d moved = opened_m * collision.normal;
  Vector3d accelerated = gained_m_s * collision.normal;
  if (settings.friction > 0) {
    const Vector3d slid = apart - between_contact_points(pair, collision, before);
    moved += rubbed_off(slid, collision.normal, settings.friction, opened_m);
    accelerated += rubbed_off(velocity, collision.normal, settings.friction, gained_m_s);
  }
  for (int k = 0; k < 4; ++k) {
    const int vertex = pair.vertices[static_cast<std::size_t>(k)];
    if (vertex >= cloth.particle_count()) continue;
    const double share = collision.weights[k] * cloth.inverse_mass(vertex) / mobility;
    cloth.positions.col(vertex) += share * moved;
    cloth.velocities.col(vertex) += share * accelerated;
  }
}

}  // namespace ribbon
