#include "simulation/truncation/contact_candidates.h"

#include <algorithm>
#include <cmath>

#include "geometry/vectors.h"
#include "parallel/parallel.h"
#include "simulation/detection/closest_weights.h"
#include "simulation/detection/swept_pairs.h"
#include "simulation/detection/vertex_ranges.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// The target, or where the longest displacement toward it ends.
Vector3d within_longest_displacement(const BroadPhaseLengths& lengths, const Vector3d& from,
                                     const Vector3d& target) {
  const Vector3d displacement = target - from;
  const double longest_m = lengths.longest_displacement_m;
  const bool is_long = squared_length_of(displacement) > longest_m * longest_m;
  return from + (is_long ? longest_m * safely_normalised(displacement) : displacement);
}

std::vector<MovingBox> motion_bounds(const BroadPhaseLengths& lengths, const Matrix3Xd& from,
                                     const Matrix3Xd& target) {
  Matrix3Xd end(3, from.cols());
  for (int particle = 0; particle < from.cols(); ++particle)
    end.col(particle) =
        within_longest_displacement(lengths, from.col(particle), target.col(particle));
  std::vector<MovingBox> bounds = vertex_ranges(from, end);
  for (MovingBox& bound : bounds) bound.end.grow(lengths.slack_m);
  return bounds;
}

// How particles move inside their bounds: by a displacement, and beside it as far as their freedom
// goes.
struct Motion {
  Matrix3Xd displacements;       // to the middles of the bounds
  std::vector<double> freedoms;  // m
};

Motion motion_within(const std::vector<MovingBox>& bounds, const Matrix3Xd& from) {
  Motion motion{Matrix3Xd(3, from.cols()), std::vector<double>(bounds.size())};
  for (int particle = 0; particle < from.cols(); ++particle) {
    const Box& end = bounds[particle].end;
    const Vector3d middle = (end.low + end.high) / 2;
    motion.displacements.col(particle) = middle - from.col(particle);
    motion.freedoms[particle] = length_of(end.high - middle);
  }
  return motion;
}

// The largest difference between the displacements of a vertex of the one and a vertex of the other
// feature.
double largest_difference_m(const FeaturePair& pair, const Matrix3Xd& of_particles) {
  const Eigen::Matrix<double, 3, 4> d = displacements(pair, of_particles);
  double squared =
      std::max(squared_length_of(d.col(0) - d.col(2)), squared_length_of(d.col(0) - d.col(3)));
  if (pair.kind == FeaturePair::Kind::edge_edge)
    squared = std::max(
        {squared, squared_length_of(d.col(1) - d.col(2)), squared_length_of(d.col(1) - d.col(3))});
  else
    squared = std::max(squared, squared_length_of(d.col(0) - d.col(1)));
  return std::sqrt(squared);
}

// Boxes meet long before what is inside them does: measures the pairs and adds those that are not
// too far apart for how differently their vertices can move.
void add_near_pairs(const std::vector<FeaturePair>& pairs, const Bodies& bodies, double reach_m,
                    ContactCandidates& candidates) {
  const Motion motion = motion_within(candidates.bounds, candidates.from);
  const VertexPositions from = bodies.vertices(candidates.from);
  std::vector<double> distances(pairs.size());
  std::vector<char> is_near(pairs.size());
  parallel_ranges(pairs.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto freedom_m = [&](int k) {
        const int vertex = pairs[i].vertices[k];
        return bodies.is_particle(vertex) ? motion.freedoms[vertex] : 0;
      };
      const auto x = corners(pairs[i], from);
      distances[i] = length_of(weighted_sum(x, closest_weights(pairs[i].kind, x)));
      const bool edges = pairs[i].kind == FeaturePair::Kind::edge_edge;
      const double middle_m = freedom_m(1);
      const double last_m = std::max(freedom_m(2), freedom_m(3));
      const double freedoms_m = edges ? std::max(freedom_m(0), middle_m) + last_m
                                      : freedom_m(0) + std::max(middle_m, last_m);
      const double approach_m = largest_difference_m(pairs[i], motion.displacements) + freedoms_m;
      is_near[i] = distances[i] <= reach_m + approach_m ? 1 : 0;
    }
  });
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (is_near[i] == 0) continue;
    candidates.pairs.push_back(pairs[i]);
    candidates.distances_m.push_back(distances[i]);
  }
}

void drop_pairs_of(std::span<const int> particles, ContactCandidates& candidates) {
  const std::vector<char> is_named =
      flags_of(particles, static_cast<int>(candidates.bounds.size()));
  std::vector<FeaturePair>& pairs = candidates.pairs;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (has_any(pairs[i], is_named)) continue;
    pairs[kept] = pairs[i];
    candidates.distances_m[kept++] = candidates.distances_m[i];
  }
  pairs.resize(kept);
  candidates.distances_m.resize(kept);
}

}  // namespace

ContactCandidates find_contact_candidates(Bodies& bodies, const BroadPhaseLengths& lengths,
                                          const Matrix3Xd& from, const Matrix3Xd& target) {
  ContactCandidates candidates;
  candidates.from = from;
  candidates.bounds = motion_bounds(lengths, from, target);
  add_near_pairs(pairs_within_ranges(bodies, candidates.bounds, lengths.reach_m), bodies,
                 lengths.reach_m, candidates);
  return candidates;
}

void widen(std::span<const int> particles, Widening widening, Bodies& bodies,
           const BroadPhaseLengths& lengths, const Matrix3Xd& target,
           ContactCandidates& candidates) {
  for (const int particle : particles) {
    MovingBox& bound = candidates.bounds[particle];
    Box onward = Box::around(
        within_longest_displacement(lengths, candidates.from.col(particle), target.col(particle)));
    onward.grow(lengths.slack_m);
    bound.end.include(onward);
    if (widening == Widening::onward_and_back) bound.end.include(bound.start);
  }
  drop_pairs_of(particles, candidates);
  add_near_pairs(pairs_of_changed_ranges(particles, bodies, candidates.bounds), bodies,
                 lengths.reach_m, candidates);
}

std::vector<std::size_t> approaching_pairs(const ContactCandidates& candidates,
                                           const Matrix3Xd& positions,
                                           const Matrix3Xd& displacement, double distance_m) {
  constexpr std::size_t grain = 1024;
  const Matrix3Xd gone = positions - candidates.from;
  Eigen::VectorXd moved_m(gone.cols());
  for (Eigen::Index vertex = 0; vertex < gone.cols(); ++vertex)
    moved_m[vertex] = length_of(gone.col(vertex)) + length_of(displacement.col(vertex));
  const auto reach_m = [&](int vertex) { return vertex < moved_m.size() ? moved_m[vertex] : 0; };
  const std::vector<FeaturePair>& pairs = candidates.pairs;
  std::vector<std::vector<std::size_t>> parts((pairs.size() + grain - 1) / grain);
  parallel_ranges(pairs.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      // What has hardly moved is told by that alone; the rest by how differently it moved.
      const double room_m = candidates.distances_m[i] - distance_m;
      const auto& v = pairs[i].vertices;
      if (2 * std::max({reach_m(v[0]), reach_m(v[1]), reach_m(v[2]), reach_m(v[3])}) < room_m)
        continue;
      if (largest_difference_m(pairs[i], gone) + largest_difference_m(pairs[i], displacement) >=
          room_m)
        parts[begin / grain].push_back(i);
    }
  });
  std::vector<std::size_t> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::vector<int> particles_outside(const ContactCandidates& candidates, const Matrix3Xd& target) {
  std::vector<int> outside;
  for (int particle = 0; particle < target.cols(); ++particle)
    if (!candidates.bounds[particle].end.contains(target.col(particle)))
      outside.push_back(particle);
  return outside;
}

}  // namespace ribbon
