#include "simulation/strain_limit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace ribbon {

namespace {

constexpr double negligible = 0.002;  // of an edge's natural length
constexpr double published = 0.1;     // the limit of section 5.5
constexpr double least_aim = 0.02;

}  // namespace

StrainLimit::StrainLimit(std::vector<Spring> edges, std::vector<double> limits)
    : edges_(std::move(edges)), limits_(std::move(limits)) {
  assert(edges_.size() == limits_.size());
}

bool StrainLimit::tighten(Eigen::Matrix3Xd& positions) const {
  bool any = false;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Spring& edge = edges_[i];
    const Eigen::Vector3d apart = positions.col(edge.b) - positions.col(edge.a);
    const double length_m = apart.norm();
    const double allowed_m = std::clamp(length_m, (1 - limits_[i]) * edge.rest_length_m,
                                        (1 + limits_[i]) * edge.rest_length_m);
    // A collapsed edge has no direction to grow in; its neighbours give it one.
    if (length_m == allowed_m || length_m == 0) continue;
    any = any || std::abs(length_m - allowed_m) > negligible * edge.rest_length_m;
    const Eigen::Vector3d way = 0.5 * (length_m - allowed_m) / length_m * apart;
    positions.col(edge.a) += way;
    positions.col(edge.b) -= way;
  }
  return any;
}

double StrainLimit::worst_excess(const Eigen::Matrix3Xd& positions) const {
  double worst = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Spring& edge = edges_[i];
    const double length_m = (positions.col(edge.b) - positions.col(edge.a)).norm();
    worst = std::max(worst, std::abs(length_m / edge.rest_length_m - 1) - limits_[i]);
  }
  return worst;
}

double aimed_strain(double strain, double rest_m, double rounding_m) {
  // Rounding moves each end by at most sqrt 3 roundings.
  const double recorded = 2 * std::numbers::sqrt3 * rounding_m / rest_m;
  return std::max(least_aim, std::min(strain, 0.99 * published - recorded - strain_left_over));
}

}  // namespace ribbon
