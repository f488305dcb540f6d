#include "simulation/truncation/contact_constraints.h"

#include <algorithm>

#include "simulation/detection/closest_weights.h"

namespace ribbon {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

namespace {

// Beyond the minimum separation, so that nothing has to be truncated.
constexpr double clear_of_truncation = 1.2;
constexpr double negligible_violation = 1e-3;  // of a distance

}  // namespace

std::vector<ContactConstraint> contact_constraints(const ContactCandidates& candidates,
                                                   const Bodies& bodies,
                                                   const PairDistances& distances, double reach_m,
                                                   const Matrix3Xd& free_positions,
                                                   const Cloth& cloth) {
  std::vector<ContactConstraint> constraints;
  const VertexPositions vertices = bodies.vertices(free_positions);
  for (const std::size_t i :
       approaching_pairs(candidates, free_positions, cloth.positions - free_positions, reach_m)) {
    const FeaturePair& pair = candidates.pairs[i];
    const auto x = corners(pair, vertices);
    ContactConstraint constraint;
    constraint.vertices = pair.vertices;
    constraint.weights = closest_weights(pair.kind, x);
    const Vector3d apart = x * constraint.weights;
    const double distance_m = apart.norm();
    for (int k = 0; k < 4; ++k)
      constraint.corrections[k] = bodies.is_particle(pair.vertices[k]) ? constraint.weights[k] : 0;
    // Of particles of mass 1.
    const double effective_inverse_mass = constraint.corrections.dot(constraint.weights);
    if (distance_m == 0 || effective_inverse_mass == 0) continue;
    constraint.corrections /= effective_inverse_mass;
    constraint.normal = apart / distance_m;
    constraint.distance_m =
        std::min(distances.activation_m(pair),
                 std::max(distance_m, clear_of_truncation * distances.min_separation_m(pair)));
    constraints.push_back(constraint);
  }
  return constraints;
}

bool keep_apart(std::span<const ContactConstraint> constraints, const Bodies& bodies,
                RowActivity& activity, Matrix3Xd& positions) {
  const VertexPositions vertices = bodies.vertices(positions);
  bool any = false;
  for (const ContactConstraint& constraint : constraints) {
    double distance_m = 0;
    for (int k = 0; k < 4; ++k)
      distance_m += constraint.weights[k] * constraint.normal.dot(vertices[constraint.vertices[k]]);
    const double violation_m = constraint.distance_m - distance_m;
    if (violation_m <= 0) continue;
    any = any || violation_m > negligible_violation * constraint.distance_m;
    for (int k = 0; k < 4; ++k) {
      if (constraint.corrections[k] == 0) continue;
      const int particle = constraint.vertices[k];
      positions.col(particle) += constraint.corrections[k] * violation_m * constraint.normal;
      activity.move(bodies.grid.row(particle));
    }
  }
  return any;
}

}  // namespace ribbon
