#include "simulation/contact/pair_distances.h"

#include <algorithm>
#include <span>
#include <utility>

#include "geometry/vectors.h"

namespace ribbon {

namespace {

// By how much the intervals differ that hold what `number` gives for the vertices of two features.
template <class Number>
auto apart(std::span<const int> first, std::span<const int> second, const Number& number) {
  using Kind = decltype(number(0));
  const auto interval = [&number](std::span<const int> vertices) {
    std::pair<Kind, Kind> result{number(vertices[0]), number(vertices[0])};
    for (const int vertex : vertices) {
      result.first = std::min(result.first, number(vertex));
      result.second = std::max(result.second, number(vertex));
    }
    return result;
  };
  const auto [first_low, first_high] = interval(first);
  const auto [second_low, second_high] = interval(second);
  return std::max({Kind{0}, first_low - second_high, second_low - first_high});
}

}  // namespace

// Between columns; in a band with a width profile they are no parallels.
double PairDistances::distance_across_m(std::span<const int> first,
                                        std::span<const int> second) const {
  if (size_.has_profile())
    return apart(first, second, [this](int vertex) { return size_.place_m(vertex).y(); });
  const auto column = [this](int vertex) { return size_.grid.column(vertex); };
  return apart(first, second, column) * size_.across_m();
}

// At least; exactly so for features beside or above each other.
double PairDistances::rest_distance_m(const FeaturePair& pair) const {
  const std::size_t first_count = pair.kind == FeaturePair::Kind::vertex_triangle ? 1 : 2;
  const std::span<const int> first = std::span(pair.vertices).first(first_count);
  const std::span<const int> second = std::span(pair.vertices).subspan(first_count);
  const auto row = [this](int vertex) { return size_.grid.row(vertex); };
  const double distance_m = length_of(Eigen::Vector2d(apart(first, second, row) * size_.along_m(),
                                                      distance_across_m(first, second)));
  // No two features that share no vertex are closer than a corner of a quad and its diagonal.
  const double across_m = size_.narrowest_m() / (size_.grid.across - 1);
  const double corner_to_diagonal_m =
      size_.along_m() * across_m / length_of(Eigen::Vector2d(size_.along_m(), across_m));
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
