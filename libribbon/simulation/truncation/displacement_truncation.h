// Displacement truncation, the gate that all positions pass: no pair of features comes closer than
// a minimum separation.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "simulation/contact/pair_distances.h"
#include "simulation/truncation/contact_candidates.h"

namespace ribbon {

struct TruncationReport {
  int truncated = 0;            // particles that did not reach their targets
  double farthest_m = 0;        // the longest displacement that was left to a particle
  std::vector<int> stragglers;  // particles that would fall behind their bounds: nothing was moved
};

// Moves `positions` (3 x particles, inside their bounds, where the broad phase found them or at the
// end of its displacements) toward `target`, as far as it is certain that no two features that
// share no vertex come closer than their minimum separation (at most the broad phase's reach), or,
// where they are closer already, any closer at all.
//
// Each listed pair bounds the displacements of its vertices by a plane (displacement_fractions); a
// particle takes the shortest of its displacements and stays inside its bound. Truncating a
// displacement keeps a particle on its side of every plane, so all planes hold at every instant of
// the straight motion; a pair that is not listed cannot meet inside the bounds. What is truncated
// because another layer was still in the way may go on when this is done again.
//
// Cf. per-vertex conservative bounds (Offset Geometric Contact, Chen et al. 2025).
TruncationReport truncate_displacements(const ContactCandidates& candidates, const Bodies& bodies,
                                        const PairDistances& distances,
                                        const Eigen::Matrix3Xd& target,
                                        Eigen::Matrix3Xd& positions);

}  // namespace ribbon
