#include "simulation/strain_limit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ribbon {

namespace {

constexpr double negligible = 0.002;  // of an edge's natural length

}  // namespace

StrainLimit::StrainLimit(std::vector<Spring> edges, double limit)
    : edges_(std::move(edges)), limit_(limit) {}

bool StrainLimit::tighten(Eigen::Matrix3Xd& positions) const {
  bool any = false;
  for (const Spring& edge : edges_) {
    const Eigen::Vector3d apart = positions.col(edge.b) - positions.col(edge.a);
    const double length_m = apart.norm();
    const double allowed_m =
        std::clamp(length_m, (1 - limit_) * edge.rest_length_m, (1 + limit_) * edge.rest_length_m);
    // A collapsed edge has no direction to grow in; its neighbours give it one.
    if (length_m == allowed_m || length_m == 0) continue;
    any = any || std::abs(length_m - allowed_m) > negligible * edge.rest_length_m;
    const Eigen::Vector3d way = 0.5 * (length_m - allowed_m) / length_m * apart;
    positions.col(edge.a) += way;
    positions.col(edge.b) -= way;
  }
  return any;
}

double StrainLimit::worst(const Eigen::Matrix3Xd& positions) const {
  double worst = 0;
  for (const Spring& edge : edges_) {
    const double length_m = (positions.col(edge.b) - positions.col(edge.a)).norm();
    worst = std::max(worst, std::abs(length_m / edge.rest_length_m - 1));
  }
  return worst;
}

}  // namespace ribbon
