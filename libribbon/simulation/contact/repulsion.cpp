#include "simulation/contact/repulsion.h"

#include <algorithm>
#include <optional>

#include "geometry/vectors.h"
#include "simulation/contact/friction.h"

namespace ribbon {

namespace {

using Eigen::Vector3d;

constexpr double restitution = 0.1;  // small, for stability

// The vector from the contact point of the second feature to that of the first.
Vector3d between_contact_points(const FeaturePair& pair, const Collision& collision,
                                const VertexPositions& positions) {
  Vector3d result = Vector3d::Zero();
  for (int k = 0; k < 4; ++k) result += collision.weights[k] * positions[pair.vertices[k]];
  return result;
}

// The velocity of the contact point of the first feature as seen from that of the second.
Vector3d relative_velocity(const FeaturePair& pair, const Collision& collision,
                           const Cloth& cloth) {
  Vector3d result = Vector3d::Zero();
  for (int k = 0; k < 4; ++k)
    if (pair.vertices[k] < cloth.particle_count())
      result += collision.weights[k] * cloth.velocities.col(pair.vertices[k]);
  return result;
}

// How far the contact points part per unit of impulse between them.
double effective_inverse_mass(const FeaturePair& pair, const Collision& collision,
                              const Cloth& cloth) {
  double sum = 0;
  for (int k = 0; k < 4; ++k)
    if (pair.vertices[k] < cloth.particle_count())
      sum += collision.weights[k] * collision.weights[k] * cloth.inverse_mass(pair.vertices[k]);
  return sum;
}

}  // namespace

void repel(const FeaturePair& pair, const Collision& collision, double activation_m,
           double friction, const VertexPositions& before, const VertexPositions& now,
           Cloth& cloth) {
  const double inverse_mass = effective_inverse_mass(pair, collision, cloth);
  if (inverse_mass == 0) return;
  const Vector3d& normal = collision.normal;
  const Vector3d apart = between_contact_points(pair, collision, now);
  const Vector3d velocity = relative_velocity(pair, collision, cloth);
  const double distance_m = dot(normal, apart);
  const double speed_m_s = dot(normal, velocity);  // positive: parting
  const double opened_m = std::max(0.0, activation_m - distance_m);
  const double gained_m_s = speed_m_s < 0 ? -(1 + restitution) * speed_m_s : 0;
  Vector3d moved = opened_m * normal;
  Vector3d accelerated = gained_m_s * normal;
  if (friction > 0) {
    const Vector3d slid = apart - between_contact_points(pair, collision, before);
    moved += friction_impulse(slid, normal, friction, opened_m);
    accelerated += friction_impulse(velocity, normal, friction, gained_m_s);
  }
  for (int k = 0; k < 4; ++k) {
    const int vertex = pair.vertices[k];
    if (vertex >= cloth.particle_count()) continue;
    const double part = collision.weights[k] * cloth.inverse_mass(vertex) / inverse_mass;
    cloth.positions.col(vertex) += part * moved;
    cloth.velocities.col(vertex) += part * accelerated;
  }
}

bool repel_once(std::span<const FeaturePair> pairs, const PairDistances& distances, double friction,
                const Bodies& bodies, const Eigen::Matrix3Xd& before, Cloth& cloth) {
  const VertexPositions start = bodies.vertices(before);
  const VertexPositions now = bodies.vertices(cloth.positions);
  bool any = false;
  for (const FeaturePair& pair : pairs) {
    // Earlier repulsions of this round count: each pair is tested where its vertices are by now.
    const double activation_m = distances.activation_m(pair);
    const std::optional<Collision> collision = find_collision(pair, start, now, activation_m);
    if (!collision) continue;
    repel(pair, *collision, activation_m, friction, start, now, cloth);
    any = true;
  }
  return any;
}

}  // namespace ribbon
