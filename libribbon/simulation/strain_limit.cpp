#include "simulation/strain_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace ribbon {

namespace {

constexpr double negligible = 0.002;  // of an edge's natural length
constexpr double published = 0.1;     // the limit of section 5.5
constexpr double least_aim = 0.02;

// Was any of them beyond its limit by more than is negligible?
bool tighten_all(const LimitedEdges& edges, const RibbonGrid& grid, Eigen::Matrix3Xd& positions) {
  const double rest_length_m = edges.kind.rest_length_m;
  const double shortest_m = (1 - edges.limit) * rest_length_m;
  const double longest_m = (1 + edges.limit) * rest_length_m;
  bool any = false;
  for_each_edge(grid, edges.kind, [&](int a, int b) {
    const Eigen::Vector3d apart = positions.col(b) - positions.col(a);
    const double length_m = apart.norm();
    const double allowed_m = std::clamp(length_m, shortest_m, longest_m);
    // A collapsed edge has no direction to grow in; its neighbours give it one.
    if (length_m == allowed_m || length_m == 0) return;
    any = any || std::abs(length_m - allowed_m) > negligible * rest_length_m;
    const Eigen::Vector3d way = 0.5 * (length_m - allowed_m) / length_m * apart;
    positions.col(a) += way;
    positions.col(b) -= way;
  });
  return any;
}

}  // namespace

StrainLimit::StrainLimit(const RibbonGrid& grid, std::vector<LimitedEdges> edges)
    : grid_(grid), edges_(std::move(edges)) {}

bool StrainLimit::tighten(Eigen::Matrix3Xd& positions) const {
  bool any = false;
  for (const LimitedEdges& edges : edges_) any = tighten_all(edges, grid_, positions) || any;
  return any;
}

double StrainLimit::worst_excess(const Eigen::Matrix3Xd& positions) const {
  double worst = -std::numeric_limits<double>::infinity();
  for (const LimitedEdges& edges : edges_)
    for_each_edge(grid_, edges.kind, [&](int a, int b) {
      const double length_m = (positions.col(b) - positions.col(a)).norm();
      worst = std::max(worst, std::abs(length_m / edges.kind.rest_length_m - 1) - edges.limit);
    });
  return worst;
}

double aimed_strain(double strain, double rest_m, double rounding_m) {
  // Rounding moves each end by at most sqrt 3 roundings.
  const double recorded = 2 * std::numbers::sqrt3 * rounding_m / rest_m;
  return std::max(least_aim, std::min(strain, 0.99 * published - recorded - strain_left_over));
}

}  // namespace ribbon
