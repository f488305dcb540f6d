// Displacement truncation, the gate that all positions pass: no pair of features comes closer than
// a minimum separation.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "simulation/contact/pair_distances.h"
#include "simulation/detection/vertex_positions.h"
#include "simulation/truncation/contact_candidates.h"
#include "simulation/truncation/pairs_of_particles.h"

namespace ribbon {

struct TruncationReport {
  int truncated = 0;            // particles that did not reach their targets
  double farthest_m = 0;        // the longest displacement that was left to a particle
  std::vector<int> stragglers;  // particles that would fall behind their bounds: nothing was moved
};

// Keeps its memory from one truncation to the next.
class DisplacementTruncation {
 public:
  // Moves `positions` (3 x particles, inside their bounds, where the broad phase found them or
  // at the end of its displacements) toward `target`, as far as it is certain that no two
  // features that share no vertex come closer than their minimum separation (at most what they are
  // listed for), or, where they are closer already, any closer at all.
  //
  // The vertices of most listed pairs are displaced so much alike, truncated as they are, that
  // they cannot come that close. Each other pair bounds the displacements of its vertices by a
  // plane (displacement_fractions); a particle takes the shortest of its displacements and stays
  // inside its bound. Truncating a displacement keeps a particle on its side of every plane,
  // so all planes hold at every instant of the straight motion; a pair that is not listed
  // cannot meet inside the bounds. What is truncated because another layer was still in the
  // way may go on when this is done again.
  //
  // Cf. per-vertex conservative bounds (Offset Geometric Contact, Chen et al. 2025).
  const TruncationReport& truncate(const ContactCandidates& candidates, const Bodies& bodies,
                                   const PairDistances& distances, const Eigen::Matrix3Xd& target,
                                   Eigen::Matrix3Xd& positions);

 private:
  // What is truncated at present.
  struct Motion {
    const ContactCandidates& candidates;
    const PairDistances& distances;
    VertexPositions start;
  };

  // What becomes of some of the particles.
  struct Outcome {
    int truncated = 0;
    double farthest_m = 0;
    std::vector<int> stragglers;
  };

  void find_least_fractions(const Motion& motion, const Eigen::Matrix3Xd& positions);
  void bound(const Motion& motion, std::span<const std::size_t> pairs);
  void lower(int particle, double fraction);
  void take_lowered();
  void find_touched_among(std::span<const FeaturePair> pairs);
  void find_touched(int round);
  void advance(const ContactCandidates& candidates, const Eigen::Matrix3Xd& target,
               const Eigen::Matrix3Xd& positions);
  [[nodiscard]] bool is_particle(int vertex) const { return vertex < displacement_.cols(); }

  TruncationReport report_;
  ApproachingPairs approaching_;
  Eigen::Matrix3Xd reached_;       // the targets inside the bounds, then what of them is reached
  Eigen::Matrix3Xd displacement_;  // to these targets
  std::vector<double> fractions_;  // of its displacement, that each particle may go
  Eigen::Matrix3Xd allowed_;       // what these leave of the displacements
  std::vector<Eigen::Vector4d> of_pair_;
  std::vector<int> last_looked_at_;  // the round in which each pair was; -1: in none
  std::vector<int> lowered_;         // particles whose fractions were, in the present round
  std::vector<char> is_lowered_;     // is the particle one of them?
  std::vector<int> taken_;           // those of the round before
  PairsOfParticles pairs_of_;
  std::vector<std::size_t> touched_;  // pairs that have one of these and are not bounded
  std::vector<Outcome> outcomes_;
};

}  // namespace ribbon
