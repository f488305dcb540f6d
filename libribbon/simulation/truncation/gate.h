// The one gate that positions pass: no pair of features comes closer than a hard minimum gap.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "simulation/contact/pair_gaps.h"
#include "simulation/truncation/surroundings.h"

namespace ribbon {

struct Passage {
  int held_back = 0;            // vertices that did not get all of their way
  double farthest_m = 0;        // the longest way that a vertex went
  std::vector<int> stragglers;  // vertices that would fall behind their range: nothing was moved
};

// Moves `positions` (3 x vertices, inside their ranges, where the survey found them or at the end
// of its ways) toward `wished`, as far as it is certain that no two features that share no vertex
// come closer than min_gap_m (at most the survey's reach), or, where they are closer already, any
// closer at all.
//
// Each listed pair bounds the ways of its vertices by a plane (shares_of_way); a vertex takes the
// shortest of its ways and stays inside its range. Shortening a way keeps a vertex on its side of
// every plane, so all planes hold at every instant of the straight motion; a pair that is not
// listed cannot meet inside the ranges. What is held back because another layer was still in the
// way may go on in a further passage.
//
// Cf. per-vertex conservative bounds (Offset Geometric Contact, Chen et al. 2025).
Passage pass_gate(const Surroundings& surroundings, const PairGaps& gaps,
                  const Eigen::Matrix3Xd& wished, Eigen::Matrix3Xd& positions);

}  // namespace ribbon
