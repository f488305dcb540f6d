#include "simulation/state/edge_strain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/vectors.h"

namespace ribbon {

using Eigen::Matrix3Xd;

namespace {

// By length alone, for all have the same at rest: no root and no quotient for each of them.
double worst_strain_of_alike(const RibbonGrid& grid, const SpringFamily& family,
                             const Matrix3Xd& positions) {
  double shortest = std::numeric_limits<double>::infinity();  // squared
  double longest = 0;
  for_each_spring(grid, family, [&](int a, int b) {
    const double squared = squared_length_of(positions.col(b) - positions.col(a));
    shortest = std::min(shortest, squared);
    longest = std::max(longest, squared);
  });
  if (shortest > longest) return 0;  // no such spring
  const double rest_m = family.rest_length_m;
  return std::max(std::abs(std::sqrt(shortest) / rest_m - 1),
                  std::abs(std::sqrt(longest) / rest_m - 1));
}

}  // namespace

double worst_strain(const RibbonGrid& grid, const SpringFamily& family,
                    const Matrix3Xd& positions) {
  if (family.rest_lengths_m.empty()) return worst_strain_of_alike(grid, family, positions);
  double worst = 0;
  for_each_spring(grid, family, [&](int a, int b) {
    worst = std::max(worst, std::abs(edge_strain(family, a, b, positions)));
  });
  return worst;
}

double worst_strain(const SpringNetwork& springs, const Matrix3Xd& positions) {
  double worst = 0;
  for (const SpringKind* kind : {&springs.stretch, &springs.shear}) {
    if (kind->stiffness == 0) continue;
    for (const SpringFamily& family : kind->families)
      worst = std::max(worst, worst_strain(springs.grid, family, positions));
  }
  return worst;
}

double change_per_s(const RibbonGrid& grid, const Matrix3Xd& positions,
                    const Matrix3Xd& velocities) {
  double squared_lengths = 0;
  double squared_speeds = 0;
  for_each_spring(grid, {.rows = 1, .columns = 0}, [&](int a, int b) {
    squared_lengths += squared_length_of(positions.col(b) - positions.col(a));
    squared_speeds += squared_length_of(velocities.col(b) - velocities.col(a));
  });
  return std::sqrt(squared_speeds / squared_lengths);
}

}  // namespace ribbon
