#include "simulation/gate.h"

#include <algorithm>
#include <vector>

#include "parallel/parallel.h"
#include "simulation/separating_plane.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector4d;

// Where each vertex wishes to be inside its range at the end.
Matrix3Xd confined(const std::vector<MovingBox>& ranges, const Matrix3Xd& wished) {
  Matrix3Xd inside(3, wished.cols());
  for (Eigen::Index vertex = 0; vertex < wished.cols(); ++vertex) {
    const Box& range = ranges[static_cast<std::size_t>(vertex)].end;
    inside.col(vertex) = wished.col(vertex).cwiseMax(range.low).cwiseMin(range.high);
  }
  return inside;
}

// The share of its way that each vertex may go: the least that any of its pairs leaves it.
class LeastShares {
 public:
  LeastShares(const Surroundings& surroundings, const PairGaps& gaps, const Matrix3Xd& positions,
              const Matrix3Xd& way)
      : surroundings_(surroundings),
        gaps_(gaps),
        positions_(positions),
        way_(way),
        shares_(Eigen::VectorXd::Ones(way.cols())) {}

  // Pairs whose vertices move together stay apart by themselves, as long as each goes all its way.
  // So first the others are bounded, and then, until no more vertices are held back, those that
  // move together no longer.
  Eigen::VectorXd find() {
    std::vector<char> is_bounded(surroundings_.pairs.size());
    std::vector<std::size_t> next =
        approaching_pairs(surroundings_, positions_, way_, gaps_.largest_hard_m() * (1 + 1e-9));
    while (!next.empty()) {
      for (const std::size_t i : next) is_bounded[i] = 1;
      bound(next);
      next.clear();
      for (std::size_t i = 0; i < is_bounded.size(); ++i)
        if (is_bounded[i] == 0 && any_is_held_back(i)) next.push_back(i);
    }
    return shares_;
  }

 private:
  [[nodiscard]] bool any_is_held_back(std::size_t i) const {
    const auto& v = surroundings_.pairs[i].vertices;
    return shares_[v[0]] < 1 || shares_[v[1]] < 1 || shares_[v[2]] < 1 || shares_[v[3]] < 1;
  }

  void bound(const std::vector<std::size_t>& indices) {
    std::vector<Vector4d> of_pair(indices.size());
    parallel_ranges(indices.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        const FeaturePair& pair = surroundings_.pairs[indices[n]];
        of_pair[n] = shares_of_way(pair.kind, corners(pair, positions_), corners(pair, way_),
                                   gaps_.hard_m(pair));
      }
    });
    for (std::size_t n = 0; n < indices.size(); ++n)
      for (int k = 0; k < 4; ++k) {
        const auto vertex = surroundings_.pairs[indices[n]].vertices[static_cast<std::size_t>(k)];
        shares_[vertex] = std::min(shares_[vertex], of_pair[n][k]);
      }
  }

  const Surroundings& surroundings_;
  const PairGaps& gaps_;
  const Matrix3Xd& positions_;
  const Matrix3Xd& way_;
  Eigen::VectorXd shares_;
};

}  // namespace

Passage pass_gate(const Surroundings& surroundings, const PairGaps& gaps, const Matrix3Xd& wished,
                  Matrix3Xd& positions) {
  const Matrix3Xd goal = confined(surroundings.ranges, wished);
  const Matrix3Xd way = goal - positions;
  const Eigen::VectorXd share = LeastShares(surroundings, gaps, positions, way).find();
  Matrix3Xd reached = goal;
  Passage passage;
  for (Eigen::Index vertex = 0; vertex < positions.cols(); ++vertex) {
    if (share[vertex] < 1) {
      reached.col(vertex) = positions.col(vertex) + share[vertex] * way.col(vertex);
      if (!surroundings.ranges[static_cast<std::size_t>(vertex)].end.contains(reached.col(vertex)))
        passage.stragglers.push_back(static_cast<int>(vertex));
    }
    passage.farthest_m = std::max(passage.farthest_m, share[vertex] * way.col(vertex).norm());
    if (reached.col(vertex) != wished.col(vertex)) ++passage.held_back;
  }
  if (passage.stragglers.empty()) positions = reached;
  return passage;
}

}  // namespace ribbon
