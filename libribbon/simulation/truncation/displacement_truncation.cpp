#include "simulation/truncation/displacement_truncation.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "geometry/vectors.h"
#include "parallel/parallel.h"
#include "simulation/truncation/separating_plane.h"

namespace ribbon {

namespace {

// Distances of nearly parallel edges are found up to a millionth of their length too large.
constexpr double roomy = 1 + 1e-4;

using Eigen::Matrix3Xd;
using Eigen::Vector4d;

// The targets, brought inside the bounds.
Matrix3Xd confined(const std::vector<MovingBox>& bounds, const Matrix3Xd& target) {
  Matrix3Xd inside(3, target.cols());
  for (int particle = 0; particle < target.cols(); ++particle) {
    const Box& bound = bounds[particle].end;
    inside.col(particle) = target.col(particle).cwiseMax(bound.low).cwiseMin(bound.high);
  }
  return inside;
}

// The fraction of its displacement that each particle may go: the least that any of its pairs
// leaves it.
class LeastFractions {
 public:
  LeastFractions(const ContactCandidates& candidates, const Bodies& bodies,
                 const PairDistances& distances, const Matrix3Xd& positions,
                 const Matrix3Xd& displacement)
      : candidates_(candidates),
        distances_(distances),
        positions_(positions),
        vertices_(bodies.vertices(positions)),
        displacement_(displacement),
        fractions_(Eigen::VectorXd::Ones(displacement.cols())) {}

  // Pairs whose vertices move together stay apart by themselves, as long as each goes all of its
  // displacement. So first the others are bounded, and then, until no more particles are truncated,
  // those that move together no longer.
  Eigen::VectorXd find() {
    is_bounded_.assign(candidates_.pairs.size(), 0);
    std::vector<std::size_t> next = approaching_pairs(
        candidates_, positions_, displacement_, distances_.largest_min_separation_m() * roomy);
    for (const std::size_t i : next) is_bounded_[i] = 1;
    while (!next.empty()) {
      bound(next);
      next = unbounded_pairs_of_truncated();
    }
    return fractions_;
  }

 private:
  void bound(const std::vector<std::size_t>& indices) {
    std::vector<Vector4d> of_pair(indices.size());
    parallel_ranges(indices.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        const FeaturePair& pair = candidates_.pairs[indices[n]];
        of_pair[n] = displacement_fractions(pair.kind, corners(pair, vertices_),
                                            displacements(pair, displacement_),
                                            distances_.min_separation_m(pair));
      }
    });
    for (std::size_t n = 0; n < indices.size(); ++n)
      for (int k = 0; k < 4; ++k) lower(candidates_.pairs[indices[n]].vertices[k], of_pair[n][k]);
  }

  [[nodiscard]] bool is_particle(int vertex) const { return vertex < displacement_.cols(); }

  void lower(int vertex, double fraction) {
    if (!is_particle(vertex)) return;
    if (fractions_[vertex] == 1 && fraction < 1) truncated_.push_back(vertex);
    fractions_[vertex] = std::min(fractions_[vertex], fraction);
  }

  // Of the particles truncated since the last time.
  std::vector<std::size_t> unbounded_pairs_of_truncated() {
    if (truncated_.empty()) return {};
    if (first_.empty()) sort_pairs_by_particle();
    std::vector<std::size_t> pairs;
    for (const int particle : truncated_)
      for (std::size_t n = first_[particle]; n < first_[particle + 1]; ++n)
        if (char& is_bounded = is_bounded_[of_particle_[n]]; is_bounded == 0) {
          is_bounded = 1;
          pairs.push_back(of_particle_[n]);
        }
    truncated_.clear();
    return pairs;
  }

  // first_[p] ... first_[p + 1] - 1: where the pairs of particle p stand in of_particle_.
  void sort_pairs_by_particle() {
    first_.assign(displacement_.cols() + 1, 0);
    for (const FeaturePair& pair : candidates_.pairs)
      for (const int vertex : pair.vertices)
        if (is_particle(vertex)) ++first_[vertex + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    of_particle_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < candidates_.pairs.size(); ++i)
      for (const int vertex : candidates_.pairs[i].vertices)
        if (is_particle(vertex)) of_particle_[next[vertex]++] = i;
  }

  const ContactCandidates& candidates_;
  const PairDistances& distances_;
  const Matrix3Xd& positions_;
  VertexPositions vertices_;
  const Matrix3Xd& displacement_;
  Eigen::VectorXd fractions_;
  std::vector<char> is_bounded_;  // of the pairs
  std::vector<int> truncated_;    // particles, since they were last asked for
  std::vector<std::size_t> first_;
  std::vector<std::size_t> of_particle_;
};

}  // namespace

TruncationReport truncate_displacements(const ContactCandidates& candidates, const Bodies& bodies,
                                        const PairDistances& distances, const Matrix3Xd& target,
                                        Matrix3Xd& positions) {
  Matrix3Xd reached = confined(candidates.bounds, target);
  const Matrix3Xd displacement = reached - positions;
  const Eigen::VectorXd fraction =
      LeastFractions(candidates, bodies, distances, positions, displacement).find();
  TruncationReport report;
  for (int p = 0; p < positions.cols(); ++p) {
    if (fraction[p] < 1) {
      reached.col(p) = positions.col(p) + fraction[p] * displacement.col(p);
      if (!candidates.bounds[p].end.contains(reached.col(p))) report.stragglers.push_back(p);
    }
    report.farthest_m = std::max(report.farthest_m, fraction[p] * length_of(displacement.col(p)));
    if (reached.col(p) != target.col(p)) ++report.truncated;
  }
  if (report.stragglers.empty()) positions.swap(reached);
  return report;
}

}  // namespace ribbon
