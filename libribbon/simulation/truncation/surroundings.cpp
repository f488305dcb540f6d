#include "simulation/truncation/surroundings.h"

#include <algorithm>
#include <cmath>

#include "parallel/parallel.h"
#include "simulation/detection/closest_weights.h"
#include "simulation/detection/swept_pairs.h"
#include "simulation/detection/vertex_ranges.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// Where a particle may wish to be: no farther than the longest way.
Vector3d end_of_way(const SurveyLengths& lengths, const Vector3d& from, const Vector3d& wished) {
  const Vector3d way = wished - from;
  const bool is_long = way.squaredNorm() > lengths.longest_way_m * lengths.longest_way_m;
  return from + (is_long ? lengths.longest_way_m * way.stableNormalized() : way);
}

std::vector<MovingBox> ranges_of(int particles, const SurveyLengths& lengths, const Matrix3Xd& from,
                                 const Matrix3Xd& wished) {
  Matrix3Xd end = from;
  for (int particle = 0; particle < particles; ++particle)
    end.col(particle) = end_of_way(lengths, from.col(particle), wished.col(particle));
  std::vector<MovingBox> ranges = vertex_ranges(from, end);
  for (int particle = 0; particle < particles; ++particle)
    ranges[static_cast<std::size_t>(particle)].end.grow(lengths.slack_m);
  return ranges;
}

// How a vertex moves: along a straight way, and around it as far as its freedom goes.
struct Motion {
  Matrix3Xd ways;                // of the middles of the ranges
  std::vector<double> freedoms;  // m
};

Motion motion_within(const std::vector<MovingBox>& ranges, const Matrix3Xd& from) {
  Motion motion{Matrix3Xd(3, from.cols()), std::vector<double>(ranges.size())};
  for (std::size_t vertex = 0; vertex < ranges.size(); ++vertex) {
    const Box& end = ranges[vertex].end;
    const auto column = static_cast<Eigen::Index>(vertex);
    const Vector3d middle = (end.low + end.high) / 2;
    motion.ways.col(column) = middle - from.col(column);
    motion.freedoms[vertex] = (end.high - middle).norm();
  }
  return motion;
}

// The largest difference between the ways of a vertex of the one and a vertex of the other feature.
double largest_difference_m(const FeaturePair& pair, const Matrix3Xd& ways) {
  const Eigen::Matrix<double, 3, 4> way = corners(pair, ways);
  double squared =
      std::max((way.col(0) - way.col(2)).squaredNorm(), (way.col(0) - way.col(3)).squaredNorm());
  if (pair.kind == FeaturePair::Kind::edge_edge)
    squared = std::max({squared, (way.col(1) - way.col(2)).squaredNorm(),
                        (way.col(1) - way.col(3)).squaredNorm()});
  else
    squared = std::max(squared, (way.col(0) - way.col(1)).squaredNorm());
  return std::sqrt(squared);
}

// Boxes meet long before what is inside them does: measures the pairs and adds those that are not
// too far apart for how differently their vertices can move.
void add_near_pairs(const std::vector<FeaturePair>& pairs, double reach_m,
                    Surroundings& surroundings) {
  const Motion motion = motion_within(surroundings.ranges, surroundings.from);
  std::vector<double> distances(pairs.size());
  std::vector<char> is_near(pairs.size());
  parallel_ranges(pairs.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto freedom_m = [&](int k) {
        return motion
            .freedoms[static_cast<std::size_t>(pairs[i].vertices[static_cast<std::size_t>(k)])];
      };
      const auto x = corners(pairs[i], surroundings.from);
      distances[i] = (x * closest_weights(pairs[i].kind, x)).norm();
      const bool edges = pairs[i].kind == FeaturePair::Kind::edge_edge;
      const double middle_m = freedom_m(1);
      const double last_m = std::max(freedom_m(2), freedom_m(3));
      const double freedoms_m = edges ? std::max(freedom_m(0), middle_m) + last_m
                                      : freedom_m(0) + std::max(middle_m, last_m);
      const double approach_m = largest_difference_m(pairs[i], motion.ways) + freedoms_m;
      is_near[i] = distances[i] <= reach_m + approach_m ? 1 : 0;
    }
  });
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (is_near[i] == 0) continue;
    surroundings.pairs.push_back(pairs[i]);
    surroundings.distances_m.push_back(distances[i]);
  }
}

void drop_pairs_of(std::span<const int> particles, Surroundings& surroundings) {
  const std::vector<char> is_named = flags_of(particles, surroundings.ranges.size());
  std::vector<FeaturePair>& pairs = surroundings.pairs;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (has_any(pairs[i], is_named)) continue;
    pairs[kept] = pairs[i];
    surroundings.distances_m[kept++] = surroundings.distances_m[i];
  }
  pairs.resize(kept);
  surroundings.distances_m.resize(kept);
}

}  // namespace

Surroundings survey(Bodies& bodies, const SurveyLengths& lengths, const Matrix3Xd& from,
                    const Matrix3Xd& wished) {
  Surroundings surroundings;
  surroundings.from = from;
  surroundings.ranges = ranges_of(bodies.grid.particle_count(), lengths, from, wished);
  add_near_pairs(pairs_within_ranges(bodies, surroundings.ranges, lengths.reach_m), lengths.reach_m,
                 surroundings);
  return surroundings;
}

void widen(std::span<const int> particles, Widening widening, Bodies& bodies,
           const SurveyLengths& lengths, const Matrix3Xd& wished, Surroundings& surroundings) {
  for (const int particle : particles) {
    MovingBox& range = surroundings.ranges[static_cast<std::size_t>(particle)];
    Box onward =
        Box::around(end_of_way(lengths, surroundings.from.col(particle), wished.col(particle)));
    onward.grow(lengths.slack_m);
    range.end.include(onward);
    if (widening == Widening::onward_and_back) range.end.include(range.start);
  }
  drop_pairs_of(particles, surroundings);
  add_near_pairs(pairs_within_ranges_of(particles, bodies, surroundings.ranges, lengths.reach_m),
                 lengths.reach_m, surroundings);
}

std::vector<std::size_t> approaching_pairs(const Surroundings& surroundings,
                                           const Matrix3Xd& positions, const Matrix3Xd& way,
                                           double distance_m) {
  constexpr std::size_t grain = 1024;
  const Matrix3Xd gone = positions - surroundings.from;
  const Eigen::VectorXd reach_m = (gone.colwise().norm() + way.colwise().norm()).transpose();
  const std::vector<FeaturePair>& pairs = surroundings.pairs;
  std::vector<std::vector<std::size_t>> parts((pairs.size() + grain - 1) / grain);
  parallel_ranges(pairs.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      // What has hardly moved is told by that alone; the rest by how differently it moved.
      const double room_m = surroundings.distances_m[i] - distance_m;
      const auto& v = pairs[i].vertices;
      if (2 * std::max({reach_m[v[0]], reach_m[v[1]], reach_m[v[2]], reach_m[v[3]]}) < room_m)
        continue;
      if (largest_difference_m(pairs[i], gone) + largest_difference_m(pairs[i], way) >= room_m)
        parts[begin / grain].push_back(i);
    }
  });
  std::vector<std::size_t> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::vector<int> vertices_outside(const Surroundings& surroundings, const Matrix3Xd& wished) {
  std::vector<int> outside;
  for (std::size_t vertex = 0; vertex < surroundings.ranges.size(); ++vertex) {
    const Vector3d wish = wished.col(static_cast<Eigen::Index>(vertex));
    if (!surroundings.ranges[vertex].end.contains(wish))
      outside.push_back(static_cast<int>(vertex));
  }
  return outside;
}

}  // namespace ribbon
