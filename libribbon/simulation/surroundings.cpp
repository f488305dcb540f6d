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

std::vector<Box> ranges_of(int particles, const SurveyLengths& lengths, const Matrix3Xd& from,
                           const Matrix3Xd& wished) {
  Matrix3Xd end = wished;
  for (int particle = 0; particle < particles; ++particle) {
    const Vector3d way = wished.col(particle) - from.col(particle);
    if (way.squaredNorm() > lengths.longest_way_m * lengths.longest_way_m)
      end.col(particle) = from.col(particle) + lengths.longest_way_m * way.stableNormalized();
  }
  std::vector<Box> ranges = vertex_ranges(from, end);
  for (int particle = 0; particle < particles; ++particle)
    ranges[static_cast<std::size_t>(particle)].grow(lengths.slack_m);
  return ranges;
}

// How far the vertices can get from where they are.
std::vector<double> radii_m(const std::vector<Box>& ranges, const Matrix3Xd& from) {
  std::vector<double> radii(ranges.size());
  for (std::size_t vertex = 0; vertex < ranges.size(); ++vertex) {
    const Vector3d centre = from.col(static_cast<Eigen::Index>(vertex));
    radii[vertex] = (ranges[vertex].high - centre).cwiseMax(centre - ranges[vertex].low).norm();
  }
  return radii;
}

// Boxes meet long before what is inside them does: measures the pairs and drops those that are too
// far apart for the ranges of their vertices.
void keep_near_pairs(double reach_m, Surroundings& surroundings) {
  const std::vector<double> radii = radii_m(surroundings.ranges, surroundings.from);
  std::vector<FeaturePair>& pairs = surroundings.pairs;
  std::vector<double>& distances = surroundings.distances_m;
  distances.resize(pairs.size());
  std::vector<char> is_near(pairs.size());
  parallel_ranges(pairs.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto radius = [&](int k) {
        return radii[static_cast<std::size_t>(pairs[i].vertices[static_cast<std::size_t>(k)])];
      };
      const auto x = corners(pairs[i], surroundings.from);
      distances[i] = (x * closest_weights(pairs[i].kind, x)).norm();
      const bool edges = pairs[i].kind == FeaturePair::Kind::edge_edge;
      const double middle = radius(1);
      const double last = std::max(radius(2), radius(3));
      const double approach =
          edges ? std::max(radius(0), middle) + last : radius(0) + std::max(middle, last);
      is_near[i] = distances[i] <= reach_m + approach ? 1 : 0;
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

}  // namespace

Surroundings survey(Bodies& bodies, const SurveyLengths& lengths, const Matrix3Xd& from,
                    const Matrix3Xd& wished) {
  Surroundings surroundings;
  surroundings.from = from;
  surroundings.ranges = ranges_of(bodies.grid.particle_count(), lengths, from, wished);
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
    const Box& range = surroundings.ranges[vertex];
    const Vector3d wish = wished.col(static_cast<Eigen::Index>(vertex));
    const bool inside =
        (range.low.array() <= wish.array()).all() && (wish.array() <= range.high.array()).all();
    outside += inside ? 0 : 1;
  }
  return outside;
}

}  // namespace ribbon
