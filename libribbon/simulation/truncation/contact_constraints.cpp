#include "simulation/truncation/contact_constraints.h"

#include <algorithm>

#include "simulation/detection/closest_weights.h"

namespace ribbon {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

namespace {

// Beyond the hard gap, so that the gate has nothing to hold back.
constexpr double clear_of_hard_gap = 1.2;
constexpr double negligible_violation = 1e-3;  // of a gap

}  // namespace

std::vector<ContactConstraint> contact_constraints(const Surroundings& surroundings,
                                                   const PairGaps& gaps, double reach_m,
                                                   const Matrix3Xd& certified, const Cloth& cloth) {
  std::vector<ContactConstraint> constraints;
  for (const std::size_t i :
       approaching_pairs(surroundings, certified, cloth.positions - certified, reach_m)) {
    const FeaturePair& pair = surroundings.pairs[i];
    const auto x = corners(pair, certified);
    ContactConstraint constraint;
    constraint.vertices = pair.vertices;
    constraint.weights = closest_weights(pair.kind, x);
    const Vector3d apart = x * constraint.weights;
    const double distance_m = apart.norm();
    for (int k = 0; k < 4; ++k) {
      const int vertex = pair.vertices[static_cast<std::size_t>(k)];
      constraint.shares[k] = vertex < cloth.particle_count() ? constraint.weights[k] : 0;
    }
    const double mobility = constraint.shares.dot(constraint.weights);
    if (distance_m == 0 || mobility == 0) continue;
    constraint.shares /= mobility;
    constraint.normal = apart / distance_m;
    constraint.gap_m =
        std::min(gaps.contact_m(pair), std::max(distance_m, clear_of_hard_gap * gaps.hard_m(pair)));
    constraints.push_back(constraint);
  }
  return constraints;
}

bool keep_apart(std::span<const ContactConstraint> constraints, const RibbonGrid& grid,
                RowActivity& activity, Matrix3Xd& positions) {
  bool any = false;
  for (const ContactConstraint& constraint : constraints) {
    const auto& v = constraint.vertices;
    double distance_m = 0;
    for (int k = 0; k < 4; ++k)
      distance_m += constraint.weights[k] *
                    constraint.normal.dot(positions.col(v[static_cast<std::size_t>(k)]));
    const double lack_m = constraint.gap_m - distance_m;
    if (lack_m <= 0) continue;
    any = any || lack_m > negligible_violation * constraint.gap_m;
    for (int k = 0; k < 4; ++k) {
      if (constraint.shares[k] == 0) continue;
      const int particle = v[static_cast<std::size_t>(k)];
      positions.col(particle) += constraint.shares[k] * lack_m * constraint.normal;
      activity.move(grid.row(particle));
    }
  }
  return any;
}

}  // namespace ribbon
