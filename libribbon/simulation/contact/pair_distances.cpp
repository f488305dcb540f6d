#include "simulation/contact/pair_distances.h"

#include <algorithm>
#include <span>

#include "geometry/vectors.h"

namespace ribbon {

namespace {

// The first and last index that `index` gives for the vertices of a feature.
struct Interval {
  int first = 0;
  int last = 0;
};
template <class Index>
Interval interval(std::span<const int> vertices, const Index& index) {
  Interval result{index(vertices[0]), index(vertices[0])};
  for (const int vertex : vertices) {
    result.first = std::min(result.first, index(vertex));
    result.last = std::max(result.last, index(vertex));
  }
  return result;
}

int apart(const Interval& a, const Interval& b) {
  return std::max({0, a.first - b.last, b.first - a.last});
}

}  // namespace

// At least; exactly so for features beside or above each other.
double PairDistances::rest_distance_m(const FeaturePair& pair) const {
  const std::size_t first_count = pair.kind == FeaturePair::Kind::vertex_triangle ? 1 : 2;
  const std::span<const int> first = std::span(pair.vertices).first(first_count);
  const std::span<const int> second = std::span(pair.vertices).subspan(first_count);
  const auto row = [this](int vertex) { return size_.grid.row(vertex); };
  const auto column = [this](int vertex) { return size_.grid.column(vertex); };
  const double distance_m = length_of(
      Eigen::Vector2d(apart(interval(first, row), interval(second, row)) * size_.along_m(),
                      apart(interval(first, column), interval(second, column)) * size_.across_m()));
  // No two features that share no vertex are closer than a corner of a quad and its diagonal.
  const double corner_to_diagonal_m = size_.along_m() * size_.across_m() /
                                      length_of(Eigen::Vector2d(size_.along_m(), size_.across_m()));
  return std::max(distance_m, corner_to_diagonal_m);
}

double PairDistances::thick_activation_m(const FeaturePair& pair) const {
  const bool with_obstacle = std::any_of(pair.vertices.begin(), pair.vertices.end(), [this](int v) {
    return v >= size_.grid.particle_count();
  });
  if (with_obstacle) return 0.5 * lengths_.thickness_m;
  return std::min(lengths_.thickness_m, 0.5 * rest_distance_m(pair));
}

}  // namespace ribbon
