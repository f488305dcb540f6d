#include "simulation/surroundings.h"

#include <algorithm>
#include <cmath>

#include "parallel/parallel.h"
#include "simulation/closest_weights.h"
#include "simulation/swept_pairs.h"
#include "simulation/vertex_ranges.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

std::vector<MovingBox> ranges_of(int particles, const SurveyLengths& lengths, const Matrix3Xd& from,
                                 const Matrix3Xd& wished, std::span<const int> stragglers) {
  Matrix3Xd end = from;
  for (int particle = 0; particle < particles; ++particle) {
    const Vector3d way = wished.col(particle) - from.col(particle);
    const bool is_long = way.squaredNorm() > lengths.longest_way_m * lengths.longest_way_m;
    end.col(particle) += is_long ? lengths.longest_way_m * way.stableNormalized() : way;
  }
  std::vector<MovingBox> ranges = vertex_ranges(from, end);
  for (int particle = 0; particle < particles; ++particle)
    ranges[static_cast<std::size_t>(particle)].end.grow(lengths.slack_m);
  for (const int particle : stragglers) {
    MovingBox& range = ranges[static_cast<std::size_t>(particle)];
    range.end.include(range.start);
  }
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

// Boxes meet long before what is inside them does: measures the pairs and drops those that are too
// far apart for how differently their vertices can move.
void keep_near_pairs(double reach_m, Surroundings& surroundings) {
  const Motion motion = motion_within(surroundings.ranges, surroundings.from);
  std::vector<FeaturePair>& pairs = surroundings.pairs;
  std::vector<double>& distances = surroundings.distances_m;
  distances.resize(pairs.size());
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
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (is_near[i] == 0) continue;
    pairs[kept] = pairs[i];
    distances[kept++] = distances[i];
  }
  pairs.resize(kept);
  distances.resize(kept);
}

}  // namespace

Surroundings survey(Bodies& bodies, const SurveyLengths& lengths, const Matrix3Xd& from,
                    const Matrix3Xd& wished, std::span<const int> stragglers) {
  Surroundings surroundings;
  surroundings.from = from;
  surroundings.ranges = ranges_of(bodies.grid.particle_count(), lengths, from, wished, stragglers);
  surroundings.pairs = pairs_within_ranges(bodies, surroundings.ranges, lengths.reach_m);
  keep_near_pairs(lengths.reach_m, surroundings);
  return surroundings;
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

int count_outside(const Surroundings& surroundings, const Matrix3Xd& wished) {
  int outside = 0;
  for (std::size_t vertex = 0; vertex < surroundings.ranges.size(); ++vertex) {
    const Vector3d wish = wished.col(static_cast<Eigen::Index>(vertex));
    outside += surroundings.ranges[vertex].end.contains(wish) ? 0 : 1;
  }
  return outside;
}

}  // namespace ribbon
