#include "simulation/contact/pair_distances.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/vectors.h"

namespace ribbon {

namespace {

// By how much the intervals differ that hold a number of the vertices of the one and of the other
// feature.
template <class Number>
Number apart(FeaturePair::Kind kind, const std::array<Number, 4>& of_vertices) {
  const auto [a, b, c, d] = of_vertices;
  const bool edges = kind == FeaturePair::Kind::edge_edge;
  const auto [first_low, first_high] = std::minmax({a, edges ? b : a});
  const auto [second_low, second_high] = std::minmax({edges ? c : b, c, d});
  return std::max({Number{0}, first_low - second_high, second_low - first_high});
}

double corner_to_diagonal_m(const RestSize& size) {
  const double across_m = size.narrowest_across_m();
  return size.along_m() * across_m / length_of(Eigen::Vector2d(size.along_m(), across_m));
}

// Whose numbers differ by so much lie farther apart in the flat ribbon than twice the thickness.
int numbers_apart_when_far(const RestSize& size, double thickness_m) {
  const double rows = std::min(2 * thickness_m / size.along_m() + 2, 1.0 * size.grid.along);
  return static_cast<int>(rows + 1) * size.grid.across;
}

}  // namespace

PairDistances::PairDistances(RestSize size, const ContactLengths& lengths)
    : size_(std::move(size)),
      lengths_(lengths),
      corner_to_diagonal_m_(corner_to_diagonal_m(size_)),
      numbers_apart_when_far_(numbers_apart_when_far(size_, lengths.thickness_m)) {}

PairReach PairDistances::activation_reach(double beyond_m) const {
  PairReach reach{largest_activation_m() + beyond_m};
  if (is_thick())
    reach.of_pair = [this, beyond_m](const FeaturePair& pair) {
      return activation_m(pair) + beyond_m;
    };
  return reach;
}

PairReach PairDistances::min_separation_reach(double times) const {
  PairReach reach{largest_min_separation_m() * times};
  if (is_thick())
    reach.of_pair = [this, times](const FeaturePair& pair) {
      return min_separation_m(pair) * times;
    };
  return reach;
}

// At least; exactly so for features beside or above each other.
double PairDistances::rest_distance_m(const FeaturePair& pair) const {
  std::array<int, 4> rows{};
  std::array<int, 4> columns{};
  for (int k = 0; k < 4; ++k) {
    rows[k] = size_.grid.row(pair.vertices[k]);
    columns[k] = pair.vertices[k] - rows[k] * size_.grid.across;
  }
  const double across_m =
      size_.has_profile() ? distance_across_m(pair) : apart(pair.kind, columns) * size_.across_m();
  const double distance_m =
      length_of(Eigen::Vector2d(apart(pair.kind, rows) * size_.along_m(), across_m));
  // No two features that share no vertex are closer than a corner of a quad and its diagonal.
  return std::max(distance_m, corner_to_diagonal_m_);
}

// Columns of a band with a width profile are no parallels.
double PairDistances::distance_across_m(const FeaturePair& pair) const {
  std::array<double, 4> places_m{};
  for (int k = 0; k < 4; ++k) places_m[k] = size_.place_m(pair.vertices[k]).y();
  return apart(pair.kind, places_m);
}

double PairDistances::thick_activation_m(const FeaturePair& pair) const {
  const bool with_obstacle = std::any_of(pair.vertices.begin(), pair.vertices.end(), [this](int v) {
    return v >= size_.grid.particle_count();
  });
  if (with_obstacle) return 0.5 * lengths_.thickness_m;
  if (apart(pair.kind, pair.vertices) >= numbers_apart_when_far_) return lengths_.thickness_m;
  return std::min(lengths_.thickness_m, 0.5 * rest_distance_m(pair));
}

}  // namespace ribbon
