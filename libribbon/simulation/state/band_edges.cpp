#include "simulation/state/band_edges.h"

#include <cmath>

namespace ribbon {

namespace {

double worst_strain(const RibbonGrid& grid, const std::array<EdgeKind, 2>& kinds,
                    const Eigen::Matrix3Xd& positions) {
  double worst = 0;
  for (const EdgeKind& kind : kinds)
    for_each_edge(grid, kind, [&](int a, int b) {
      const double length_m = (positions.col(b) - positions.col(a)).norm();
      worst = std::max(worst, std::abs(length_m / kind.rest_length_m - 1));
    });
  return worst;
}

}  // namespace

std::array<EdgeKind, 2> edges_along_and_across(const NaturalSize& size) {
  return {{{1, 0, size.along_m()}, {0, 1, size.across_m()}}};
}

std::array<EdgeKind, 2> diagonals(const NaturalSize& size) {
  const double diagonal_m = std::hypot(size.along_m(), size.across_m());
  return {{{1, 1, diagonal_m}, {1, -1, diagonal_m}}};
}

double worst_strain(const NaturalSize& size, const SpringScene& springs,
                    const Eigen::Matrix3Xd& positions) {
  double worst = 0;
  if (springs.stretch > 0) worst = worst_strain(size.grid, edges_along_and_across(size), positions);
  if (springs.shear > 0)
    worst = std::max(worst, worst_strain(size.grid, diagonals(size), positions));
  return worst;
}

}  // namespace ribbon
