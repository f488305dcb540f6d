#include "simulation/truncation/contact_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/vectors.h"
#include "parallel/parallel.h"
#include "simulation/detection/closest_weights.h"
#include "simulation/detection/swept_pairs.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// The square of the largest difference between the displacements of a vertex of the one and a
// vertex of the other feature.
double largest_squared_difference(FeaturePair::Kind kind, const Eigen::Matrix<double, 3, 4>& d) {
  double squared =
      std::max(squared_length_of(d.col(0) - d.col(2)), squared_length_of(d.col(0) - d.col(3)));
  if (kind == FeaturePair::Kind::edge_edge)
    squared = std::max(
        {squared, squared_length_of(d.col(1) - d.col(2)), squared_length_of(d.col(1) - d.col(3))});
  else
    squared = std::max(squared, squared_length_of(d.col(0) - d.col(1)));
  return squared;
}

// By how differently the vertices of the one and of the other feature are displaced.
bool is_exceeded(double room_m, const FeaturePair& pair, const Matrix3Xd& displacement) {
  if (room_m <= 0) return true;
  if (std::isinf(room_m)) return false;
  return largest_squared_difference(pair.kind, displacements(pair, displacement)) >=
         room_m * room_m;
}

constexpr std::size_t particles_at_a_time = 1024;
constexpr std::size_t pairs_at_a_time = 512;

// Of the longest way: so far from where motion leads a target may lie to be led to, and so far what
// is led goes, from its place or from where the ribbon goes as a whole.
constexpr double most_detour = 0.5;
constexpr double most_led = 64;

}  // namespace

// Around the target, if motion leads there or nearly so; else no further than the longest way.
Box BroadPhase::around_target(int particle, const Vector3d& target) const {
  const double longest_m = lengths_.longest_way_m;
  const Vector3d from = candidates_.from.col(particle);
  const Vector3d way = target - from;
  const double detour_m = length_of((target - led_.col(particle)).eval());
  const bool is_led = detour_m <= most_detour * longest_m + fall_m_;
  const double furthest_m = is_led ? most_led * longest_m : longest_m;
  const auto is_within = [furthest_m](const Vector3d& displacement) {
    return squared_length_of(displacement) <= furthest_m * furthest_m;
  };
  const auto goes_with_all = [&] {
    return is_led && fall_m_ <= furthest_m &&
           (is_within(way - common_way_) || is_within(way - common_way_ - fall_));
  };
  // What would go further is wild, wherever its velocity leads.
  Box bound = Box::around(is_within(way) || goes_with_all()
                              ? target
                              : Vector3d(from + longest_m * safely_normalised(way)));
  bound.grow(lengths_.slack_m);
  return bound;
}

void BroadPhase::set_motion(int particle) {
  const Box& end = candidates_.bounds[particle].end;
  const Vector3d middle = (end.low + end.high) / 2;
  motions_[particle] = {middle - candidates_.from.col(particle), length_of(end.high - middle)};
}

const ContactCandidates& BroadPhase::detect(Bodies& bodies, const Matrix3Xd& from,
                                            const Matrix3Xd& led, const Matrix3Xd& target,
                                            const Vector3d& fall_m) {
  candidates_.from = from;
  led_ = led;
  fall_ = fall_m;
  fall_m_ = length_of(fall_m);
  common_way_ = mean_of_columns(target) - mean_of_columns(from);
  candidates_.bounds.resize(from.cols());
  motions_.resize(from.cols());
  parallel_ranges(from.cols(), particles_at_a_time, [&](std::size_t begin, std::size_t end) {
    for (auto particle = static_cast<int>(begin); particle < static_cast<int>(end); ++particle) {
      MovingBox& bound = candidates_.bounds[particle];
      bound.start = Box::around(from.col(particle));
      bound.end = around_target(particle, target.col(particle));
      if (fall_m_ > 0) bound.end.include(around_target(particle, target.col(particle) + fall_m));
      set_motion(particle);
    }
  });
  candidates_.pairs.clear();
  candidates_.distances_m.clear();
  candidates_.weights.clear();
  list_pairs_within_ranges(bodies, candidates_.bounds, lengths_.reach_m, found_);
  add_near_pairs(bodies);
  return candidates_;
}

void BroadPhase::widen(std::span<const int> particles, Widening widening, Bodies& bodies,
                       const Matrix3Xd& target) {
  for (const int particle : particles) {
    MovingBox& bound = candidates_.bounds[particle];
    bound.end.include(around_target(particle, target.col(particle)));
    if (widening == Widening::onward_and_back) bound.end.include(bound.start);
    set_motion(particle);
  }
  drop_pairs_of(particles);
  list_pairs_of_changed_ranges(particles, bodies, candidates_.bounds, found_);
  add_near_pairs(bodies);
}

void BroadPhase::drop_pairs_of(std::span<const int> particles) {
  is_named_.assign(candidates_.bounds.size(), 0);
  for (const int particle : particles) is_named_[particle] = 1;
  std::vector<FeaturePair>& pairs = candidates_.pairs;
  std::vector<double>& distances_m = candidates_.distances_m;
  std::vector<Eigen::Vector4d>& weights = candidates_.weights;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (has_any(pairs[i], is_named_)) continue;
    pairs[kept] = pairs[i];
    distances_m[kept] = distances_m[i];
    weights[kept++] = weights[i];
  }
  pairs.resize(kept);
  distances_m.resize(kept);
  weights.resize(kept);
}

bool BroadPhase::could_meet(const FeaturePair& pair, double distance_m, double approach_m) const {
  if (distance_m > lengths_.reach_m + approach_m) return false;
  return !distances_ || distance_m <= distances_->activation_m(pair) + approach_m;
}

// Boxes meet long before what is inside them does: measures the pairs and adds those that are not
// too far apart for how differently their vertices can move.
void BroadPhase::add_near_pairs(const Bodies& bodies) {
  const VertexPositions from = bodies.vertices(candidates_.from);
  distances_m_.resize(found_.size());
  weights_.resize(found_.size());
  is_near_.resize(found_.size());
  parallel_ranges(found_.size(), pairs_at_a_time, [&](std::size_t begin, std::size_t end) {
    const Motion still{Vector3d::Zero()};
    for (std::size_t i = begin; i < end; ++i) {
      const FeaturePair& pair = found_[i];
      Eigen::Matrix<double, 3, 4> displacements;
      std::array<double, 4> freedoms_m{};
      for (int k = 0; k < 4; ++k) {
        const int vertex = pair.vertices[k];
        const Motion& motion = bodies.is_particle(vertex) ? motions_[vertex] : still;
        displacements.col(k) = motion.displacement;
        freedoms_m[k] = motion.freedom_m;
      }
      const auto x = corners(pair, from);
      weights_[i] = closest_weights(pair.kind, x);
      distances_m_[i] = length_of(weighted_sum(x, weights_[i]));
      const bool edges = pair.kind == FeaturePair::Kind::edge_edge;
      const double last_m = std::max(freedoms_m[2], freedoms_m[3]);
      const double freedom_m = edges ? std::max(freedoms_m[0], freedoms_m[1]) + last_m
                                     : freedoms_m[0] + std::max(freedoms_m[1], last_m);
      const double approach_m =
          std::sqrt(largest_squared_difference(pair.kind, displacements)) + freedom_m;
      is_near_[i] = could_meet(pair, distances_m_[i], approach_m) ? 1 : 0;
    }
  });
  for (std::size_t i = 0; i < found_.size(); ++i) {
    if (is_near_[i] == 0) continue;
    candidates_.pairs.push_back(found_[i]);
    candidates_.distances_m.push_back(distances_m_[i]);
    candidates_.weights.push_back(weights_[i]);
  }
}

const std::vector<std::size_t>& ApproachingPairs::find(const ContactCandidates& candidates,
                                                       const Matrix3Xd& positions,
                                                       const Matrix3Xd& displacement,
                                                       const PairReach& reach,
                                                       RestingPairs resting) {
  measure(candidates, positions, displacement);
  const auto moved_m = [&](int vertex) {
    return vertex < std::ssize(moved_m_) ? moved_m_[vertex] : 0;
  };
  const auto rests = [&](int vertex) {
    return vertex >= std::ssize(is_resting_) || is_resting_[vertex] != 0;
  };
  const std::vector<FeaturePair>& pairs = candidates.pairs;
  rooms_m_.resize(pairs.size());
  is_approaching_.resize(pairs.size());
  parallel_ranges(pairs.size(), pairs_at_a_time, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const FeaturePair& pair = pairs[i];
      const auto& v = pair.vertices;
      if (resting == RestingPairs::left_out && std::all_of(v.begin(), v.end(), rests)) {
        rooms_m_[i] = std::numeric_limits<double>::infinity();
        is_approaching_[i] = 0;
        continue;
      }
      // What hardly moves is told by that alone; the rest by how differently it moves.
      const double most_m = std::max({moved_m(v[0]), moved_m(v[1]), moved_m(v[2]), moved_m(v[3])});
      double& room_m = rooms_m_[i];
      room_m = candidates.distances_m[i] - reach.largest_m;
      if (2 * most_m < room_m)
        room_m = std::numeric_limits<double>::infinity();
      else if (has_gone_)
        room_m -= std::sqrt(largest_squared_difference(pair.kind, displacements(pair, gone_)));
      bool approaches = is_exceeded(room_m, pair, displacement);
      if (approaches && reach.of_pair) {
        room_m += reach.largest_m - reach.of_pair(pair);
        approaches = is_exceeded(room_m, pair, displacement);
      }
      is_approaching_[i] = approaches ? 1 : 0;
    }
  });
  found_.clear();
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (is_approaching_[i] != 0) found_.push_back(i);
  return found_;
}

void ApproachingPairs::measure(const ContactCandidates& candidates, const Matrix3Xd& positions,
                               const Matrix3Xd& displacement) {
  has_gone_ = positions != candidates.from;
  gone_.resize(3, positions.cols());
  moved_m_.resize(positions.cols());
  is_resting_.resize(positions.cols());
  parallel_ranges(moved_m_.size(), particles_at_a_time, [&](std::size_t begin, std::size_t end) {
    for (auto particle = static_cast<int>(begin); particle < static_cast<int>(end); ++particle) {
      gone_.col(particle) = positions.col(particle) - candidates.from.col(particle);
      moved_m_[particle] = length_of(gone_.col(particle)) + length_of(displacement.col(particle));
      is_resting_[particle] = displacement.col(particle).isZero(0) ? 1 : 0;
    }
  });
}

const std::vector<std::size_t>& ApproachingPairs::find_among(std::span<const std::size_t> pairs,
                                                             const ContactCandidates& candidates,
                                                             const Matrix3Xd& displacement) {
  is_approaching_.resize(pairs.size());
  parallel_ranges(pairs.size(), pairs_at_a_time, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const std::size_t i = pairs[n];
      is_approaching_[n] = is_exceeded(rooms_m_[i], candidates.pairs[i], displacement) ? 1 : 0;
    }
  });
  found_.clear();
  for (std::size_t n = 0; n < pairs.size(); ++n)
    if (is_approaching_[n] != 0) found_.push_back(pairs[n]);
  return found_;
}

Eigen::Vector4d ApproachingPairs::weights(std::size_t pair, const ContactCandidates& candidates,
                                          const Eigen::Matrix<double, 3, 4>& corners) const {
  return has_gone_ ? closest_weights(candidates.pairs[pair].kind, corners)
                   : candidates.weights[pair];
}

void find_particles_outside(const ContactCandidates& candidates, const Matrix3Xd& target,
                            std::vector<int>& outside) {
  outside.clear();
  for (int particle = 0; particle < target.cols(); ++particle)
    if (!candidates.bounds[particle].end.contains(target.col(particle)))
      outside.push_back(particle);
}

}  // namespace ribbon
