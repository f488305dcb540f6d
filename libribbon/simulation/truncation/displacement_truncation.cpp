#include "simulation/truncation/displacement_truncation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/vectors.h"
#include "parallel/parallel.h"
#include "simulation/truncation/separating_plane.h"

namespace ribbon {

namespace {

// Distances of nearly parallel edges are found up to a millionth of their length too large.
constexpr double roomy = 1 + 1e-4;

using Eigen::Matrix3Xd;

constexpr std::size_t particles_at_a_time = 1024;
constexpr int bounded = std::numeric_limits<int>::max();  // looked at last, after all rounds

}  // namespace

// Pairs whose vertices move together stay apart by themselves. So first the others are bounded, and
// then, until no fraction falls any more, those whose vertices no longer move together because one
// of them was truncated.
void DisplacementTruncation::find_least_fractions(const Motion& motion,
                                                  const Matrix3Xd& positions) {
  const ContactCandidates& candidates = motion.candidates;
  fractions_.assign(displacement_.cols(), 1);
  is_lowered_.assign(displacement_.cols(), 0);
  last_looked_at_.assign(candidates.pairs.size(), -1);
  bound(motion,
        approaching_.find(candidates, positions, displacement_,
                          motion.distances.min_separation_reach(roomy), RestingPairs::left_out));
  if (!lowered_.empty()) allowed_ = displacement_;
  for (int round = 0; !lowered_.empty(); ++round) {
    take_lowered();
    // Mostly there is but this round, for which sorting would take longer.
    if (round == 0) {
      find_touched_among(candidates.pairs);
    } else {
      if (round == 1) pairs_of_.sort(candidates.pairs, static_cast<int>(displacement_.cols()));
      find_touched(round);
    }
    bound(motion, approaching_.find_among(touched_, candidates, allowed_));
  }
}

void DisplacementTruncation::bound(const Motion& motion, std::span<const std::size_t> pairs) {
  of_pair_.resize(pairs.size());
  const std::vector<FeaturePair>& all = motion.candidates.pairs;
  parallel_ranges(pairs.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const FeaturePair& pair = all[pairs[n]];
      const auto start = corners(pair, motion.start);
      of_pair_[n] = displacement_fractions(
          pair.kind, start, approaching_.weights(pairs[n], motion.candidates, start),
          displacements(pair, displacement_), motion.distances.min_separation_m(pair));
    }
  });
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    last_looked_at_[pairs[n]] = bounded;
    for (int k = 0; k < 4; ++k)
      if (const int vertex = all[pairs[n]].vertices[k]; is_particle(vertex))
        lower(vertex, of_pair_[n][k]);
  }
}

void DisplacementTruncation::lower(int particle, double fraction) {
  double& least = fractions_[particle];
  if (!(fraction < least)) return;
  least = fraction;
  if (is_lowered_[particle] == 0) lowered_.push_back(particle);
  is_lowered_[particle] = 1;
}

void DisplacementTruncation::take_lowered() {
  taken_.swap(lowered_);
  lowered_.clear();
  for (const int particle : taken_) {
    is_lowered_[particle] = 0;
    allowed_.col(particle) = fractions_[particle] * displacement_.col(particle);
  }
}

void DisplacementTruncation::find_touched_among(std::span<const FeaturePair> pairs) {
  const auto is_truncated = [this](int vertex) {
    return is_particle(vertex) && fractions_[vertex] < 1;
  };
  touched_.clear();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& vertices = pairs[i].vertices;
    if (last_looked_at_[i] != bounded &&
        std::any_of(vertices.begin(), vertices.end(), is_truncated))
      touched_.push_back(i);
  }
}

void DisplacementTruncation::find_touched(int round) {
  touched_.clear();
  for (const int particle : taken_)
    for (const std::size_t i : pairs_of_[particle]) {
      if (last_looked_at_[i] >= round) continue;
      last_looked_at_[i] = round;
      touched_.push_back(i);
    }
}

// Makes reached_ what the fractions leave of the displacements.
void DisplacementTruncation::advance(const ContactCandidates& candidates, const Matrix3Xd& target,
                                     const Matrix3Xd& positions) {
  const std::size_t particles = fractions_.size();
  outcomes_.resize((particles + particles_at_a_time - 1) / particles_at_a_time);
  parallel_ranges(particles, particles_at_a_time, [&](std::size_t begin, std::size_t end) {
    Outcome& outcome = outcomes_[begin / particles_at_a_time];
    outcome.truncated = 0;
    outcome.stragglers.clear();
    double farthest_squared = 0;  // of those that go all of it
    double farthest_m = 0;        // of the others
    for (auto p = static_cast<int>(begin); p < static_cast<int>(end); ++p) {
      const auto displacement = displacement_.col(p);
      if (fractions_[p] < 1) {
        reached_.col(p) = positions.col(p) + fractions_[p] * displacement;
        if (!candidates.bounds[p].end.contains(reached_.col(p))) outcome.stragglers.push_back(p);
        farthest_m = std::max(farthest_m, fractions_[p] * length_of(displacement));
      } else {
        farthest_squared = std::max(farthest_squared, squared_length_of(displacement));
      }
      if (reached_.col(p) != target.col(p)) ++outcome.truncated;
    }
    outcome.farthest_m = std::max(farthest_m, std::sqrt(farthest_squared));
  });
}

const TruncationReport& DisplacementTruncation::truncate(const ContactCandidates& candidates,
                                                         const Bodies& bodies,
                                                         const PairDistances& distances,
                                                         const Matrix3Xd& target,
                                                         Matrix3Xd& positions) {
  reached_.resize(3, target.cols());
  displacement_.resize(3, target.cols());
  parallel_ranges(target.cols(), particles_at_a_time, [&](std::size_t begin, std::size_t end) {
    for (auto p = static_cast<int>(begin); p < static_cast<int>(end); ++p) {
      const Box& bound = candidates.bounds[p].end;
      reached_.col(p) = target.col(p).cwiseMax(bound.low).cwiseMin(bound.high);
      displacement_.col(p) = reached_.col(p) - positions.col(p);
    }
  });
  find_least_fractions({candidates, distances, bodies.vertices(positions)}, positions);
  advance(candidates, target, positions);
  report_.truncated = 0;
  report_.farthest_m = 0;
  report_.stragglers.clear();
  for (const Outcome& of_some : outcomes_) {
    report_.truncated += of_some.truncated;
    report_.farthest_m = std::max(report_.farthest_m, of_some.farthest_m);
    report_.stragglers.insert(report_.stragglers.end(), of_some.stragglers.begin(),
                              of_some.stragglers.end());
  }
  if (report_.stragglers.empty()) positions.swap(reached_);
  return report_;
}

}  // namespace ribbon
