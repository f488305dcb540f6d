#include "simulation/truncation/strain_constraints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/vectors.h"
#include "simulation/contact/contact_lengths.h"
#include "simulation/state/edge_strain.h"

namespace ribbon {

namespace {

constexpr double negligible_excess = 0.004;  // of an edge's rest length
// Of the excess, but never beyond the rest length: half as many sweeps are needed as with 1.
constexpr double over_relaxation = 1.5;
constexpr double recordable_strain = 0.99 * paper_strain_limit;

struct Tightened {
  double excess = 0;  // of the rest length, that there was
  double by_m = 0;    // that each end has moved
};

// Moves the two ends of an edge that is too long or too short, and takes from them the speed at
// which it becomes more so.
Tightened tighten_edge(double aimed, double rest_m, int a, int b, Cloth& cloth) {
  const Eigen::Vector3d apart = cloth.positions.col(b) - cloth.positions.col(a);
  const double length_m = length_of(apart);
  const double excess_m =
      length_m - std::clamp(length_m, (1 - aimed) * rest_m, (1 + aimed) * rest_m);
  const double from_rest_m = length_m - rest_m;
  const double corrected_m = std::copysign(
      std::min(over_relaxation * std::abs(excess_m), std::abs(from_rest_m)), excess_m);
  const Eigen::Vector3d correction = 0.5 * corrected_m / length_m * apart;
  cloth.positions.col(a) += correction;
  cloth.positions.col(b) -= correction;
  const double worsening = dot(correction, cloth.velocities.col(b) - cloth.velocities.col(a)) /
                           squared_length_of(correction);
  if (worsening > 0) {
    cloth.velocities.col(a) += 0.5 * worsening * correction;
    cloth.velocities.col(b) -= 0.5 * worsening * correction;
  }
  return {std::abs(excess_m) / rest_m, 0.5 * std::abs(corrected_m)};
}

// Was any of them beyond what is aimed at by more than is negligible?
template <class RestLengths>
bool tighten_all(const SpringFamily& family, double aimed, const RestLengths& rest_m,
                 const RibbonGrid& grid, SweepActivity& activity, Cloth& cloth) {
  double worst = 0;
  for (int row = 0; row + family.rows < grid.along; ++row) {
    const int other_row = row + family.rows;
    if (activity.is_resting(row) && activity.is_resting(other_row)) continue;
    for_each_spring_of_row(grid, family, row, [&](int a, int b) {
      const double shortest_m = (1 - aimed) * rest_m(a);
      const double longest_m = (1 + aimed) * rest_m(a);
      const double squared = squared_length_of(cloth.positions.col(b) - cloth.positions.col(a));
      // A collapsed edge has no direction to grow in; its neighbours give it one.
      if ((squared >= shortest_m * shortest_m && squared <= longest_m * longest_m) || squared == 0)
        return;
      const auto [excess, by_m] = tighten_edge(aimed, rest_m(a), a, b, cloth);
      worst = std::max(worst, excess);
      activity.move(a, by_m);
      activity.move(b, by_m);
    });
  }
  return worst > negligible_excess;
}

}  // namespace

StrainConstraints::StrainConstraints(const RibbonGrid& grid, std::vector<LimitedFamily> families)
    : grid_(grid), families_(std::move(families)) {}

double StrainConstraints::least_held() const {
  double least = std::numeric_limits<double>::infinity();
  for (const LimitedFamily& family : families_)
    least = std::min(least, family.aimed + strain_left_over);
  return least;
}

bool StrainConstraints::tighten(SweepActivity& activity, Cloth& cloth) const {
  bool any = false;
  for (std::size_t i = 0; i < families_.size(); ++i) {
    activity.begin(first_family_task + i);
    const LimitedFamily& limited = families_[i];
    any = with_rest_lengths(limited.family,
                            [&](const auto& rest_m) {
                              return tighten_all(limited.family, limited.aimed, rest_m, grid_,
                                                 activity, cloth);
                            }) ||
          any;
  }
  return any;
}

StrainExcess StrainConstraints::excess(const Eigen::Matrix3Xd& positions) const {
  StrainExcess excess;
  for (const LimitedFamily& limited : families_) {
    const double strain = worst_strain(grid_, limited.family, positions);
    excess.beyond_aimed = std::max(excess.beyond_aimed, strain - limited.aimed);
    excess.is_bearable = excess.is_bearable && strain <= limited.most;
  }
  return excess;
}

double most_strain(double rest_m, double rounding_m) {
  return std::max(least_aimed_strain + strain_left_over,
                  recordable_strain - lost_to_rounding_m(rounding_m) / rest_m);
}

double coarsest_rounding_m(double rest_m, double strain) {
  return (recordable_strain - strain - strain_left_over) * rest_m / lost_to_rounding_m(1);
}

double aimed_strain(double strain, double rest_m, double rounding_m) {
  return std::min(strain, most_strain(rest_m, rounding_m) - strain_left_over);
}

}  // namespace ribbon
