#include "simulation/truncation/gate.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "parallel/parallel.h"
#include "simulation/truncation/separating_plane.h"

namespace ribbon {

namespace {

// Distances of nearly parallel edges are found up to a millionth of their length too large.
constexpr double roomy = 1 + 1e-4;

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
    is_bounded_.assign(surroundings_.pairs.size(), 0);
    std::vector<std::size_t> next =
        approaching_pairs(surroundings_, positions_, way_, gaps_.largest_hard_m() * roomy);
    for (const std::size_t i : next) is_bounded_[i] = 1;
    while (!next.empty()) {
      bound(next);
      next = unbounded_pairs_of_held();
    }
    return shares_;
  }

 private:
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
      for (int k = 0; k < 4; ++k)
        lower(surroundings_.pairs[indices[n]].vertices[static_cast<std::size_t>(k)], of_pair[n][k]);
  }

  void lower(int vertex, double share) {
    if (shares_[vertex] == 1 && share < 1) held_.push_back(vertex);
    shares_[vertex] = std::min(shares_[vertex], share);
  }

  // Of the vertices held back since the last time.
  std::vector<std::size_t> unbounded_pairs_of_held() {
    if (held_.empty()) return {};
    if (first_.empty()) sort_pairs_by_vertex();
    std::vector<std::size_t> pairs;
    for (const int vertex : held_)
      for (std::size_t n = first_[static_cast<std::size_t>(vertex)];
           n < first_[static_cast<std::size_t>(vertex) + 1]; ++n)
        if (char& is_bounded = is_bounded_[of_vertex_[n]]; is_bounded == 0) {
          is_bounded = 1;
          pairs.push_back(of_vertex_[n]);
        }
    held_.clear();
    return pairs;
  }

  // first_[v] ... first_[v + 1] - 1: where the pairs of vertex v stand in of_vertex_.
  void sort_pairs_by_vertex() {
    first_.assign(static_cast<std::size_t>(way_.cols()) + 1, 0);
    for (const FeaturePair& pair : surroundings_.pairs)
      for (const int vertex : pair.vertices) ++first_[static_cast<std::size_t>(vertex) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    of_vertex_.resize(4 * surroundings_.pairs.size());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < surroundings_.pairs.size(); ++i)
      for (const int vertex : surroundings_.pairs[i].vertices)
        of_vertex_[next[static_cast<std::size_t>(vertex)]++] = i;
  }

  const Surroundings& surroundings_;
  const PairGaps& gaps_;
  const Matrix3Xd& positions_;
  const Matrix3Xd& way_;
  Eigen::VectorXd shares_;
  std::vector<char> is_bounded_;  // of the pairs
  std::vector<int> held_;         // vertices, since they were last asked for
  std::vector<std::size_t> first_;
  std::vector<std::size_t> of_vertex_;
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
