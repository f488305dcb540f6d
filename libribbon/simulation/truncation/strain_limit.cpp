#include "simulation/truncation/strain_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "simulation/contact/gap_lengths.h"

namespace ribbon {

namespace {

constexpr double negligible_excess = 0.002;  // of an edge's natural length
constexpr double published = 0.1;            // the limit of section 5.5
constexpr double least_aim = 0.02;

// Moves the two ends of an edge that is too long or too short. By how much of its natural length
// was it so?
double tighten_edge(const LimitedEdges& edges, Eigen::Ref<Eigen::Vector3d> a,
                    Eigen::Ref<Eigen::Vector3d> b) {
  const double rest_length_m = edges.kind.rest_length_m;
  const Eigen::Vector3d apart = b - a;
  const double length_m = apart.norm();
  const double excess_m = length_m - std::clamp(length_m, (1 - edges.limit) * rest_length_m,
                                                (1 + edges.limit) * rest_length_m);
  const Eigen::Vector3d way = 0.5 * excess_m / length_m * apart;
  a += way;
  b -= way;
  return std::abs(excess_m) / rest_length_m;
}

// Was any of them beyond its limit by more than is negligible?
bool tighten_all(const LimitedEdges& edges, const RibbonGrid& grid, RowActivity& activity,
                 Eigen::Matrix3Xd& positions) {
  const double shortest_m = (1 - edges.limit) * edges.kind.rest_length_m;
  const double longest_m = (1 + edges.limit) * edges.kind.rest_length_m;
  double worst = 0;
  for (int row = 0; row + edges.kind.rows < grid.along; ++row) {
    const int other_row = row + edges.kind.rows;
    if (activity.is_resting(row) && activity.is_resting(other_row)) continue;
    for_each_edge_of_row(grid, edges.kind, row, [&](int a, int b) {
      const double squared = (positions.col(b) - positions.col(a)).squaredNorm();
      // A collapsed edge has no direction to grow in; its neighbours give it one.
      if ((squared >= shortest_m * shortest_m && squared <= longest_m * longest_m) || squared == 0)
        return;
      worst = std::max(worst, tighten_edge(edges, positions.col(a), positions.col(b)));
      activity.move(row);
      activity.move(other_row);
    });
  }
  return worst > negligible_excess;
}

}  // namespace

StrainLimit::StrainLimit(const RibbonGrid& grid, std::vector<LimitedEdges> edges)
    : grid_(grid), edges_(std::move(edges)) {}

bool StrainLimit::tighten(RowActivity& activity, Eigen::Matrix3Xd& positions) const {
  bool any = false;
  for (std::size_t kind = 0; kind < edges_.size(); ++kind) {
    activity.begin(kind);
    any = tighten_all(edges_[kind], grid_, activity, positions) || any;
  }
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
  const double recorded = lost_to_rounding_m(rounding_m) / rest_m;
  return std::max(least_aim, std::min(strain, 0.99 * published - recorded - strain_left_over));
}

}  // namespace ribbon
