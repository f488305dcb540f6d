#include "simulation/published/recovery.h"

#include <algorithm>
#include <vector>

#include "simulation/published/penetration.h"
#include "simulation/published/recovery_schemes.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

std::vector<Penetration> ribbon_into_obstacle(Bodies& bodies, const Matrix3Xd& positions) {
  if (!bodies.obstacle) return {};
  return mutual_penetrations(bodies.ribbon.surface(), bodies.ribbon.hierarchy(positions),
                             bodies.obstacle->surface, bodies.obstacle->hierarchy, positions)
      .edges_of_first;
}

std::vector<Penetration> ribbon_into_itself(Bodies& bodies, const Matrix3Xd& positions) {
  return self_penetrations(bodies.ribbon.surface(), bodies.ribbon.hierarchy(positions),
                           Hierarchy::Spare::curvature_and_boxes, positions);
}

std::vector<Penetration> border_into_ribbon(Bodies& bodies, const Matrix3Xd& positions) {
  std::vector<Penetration> found = ribbon_into_itself(bodies, positions);
  std::erase_if(found, [&](const Penetration& penetration) {
    return !is_border_edge(
        bodies.grid, bodies.ribbon.surface().edges[static_cast<std::size_t>(penetration.edge)]);
  });
  return found;
}

// while (∃ error) apply the scheme, until `patience` applications in a row have left no fewer
// errors than there were at best; those are taken back. `iterations` counts all applications.
template <class Detect, class Scheme>
void repeat(const Detect& detect, const Scheme& scheme, int patience, Matrix3Xd& positions,
            int& iterations) {
  std::vector<Penetration> errors = detect();
  std::size_t fewest = errors.size();
  Matrix3Xd best = positions;
  int in_vain = 0;
  while (!errors.empty() && in_vain < patience) {
    scheme(errors);
    ++iterations;
    errors = detect();
    if (errors.size() < fewest) {
      fewest = errors.size();
      best = positions;
      in_vain = 0;
    } else {
      ++in_vain;
    }
  }
  if (in_vain > 0) positions = best;
}

}  // namespace

int count_penetrating_edges(Bodies& bodies, const Matrix3Xd& positions) {
  // An honest count does not lean on curvature.
  std::vector<Penetration> of_ribbon =
      self_penetrations(bodies.ribbon.surface(), bodies.ribbon.hierarchy(positions),
                        Hierarchy::Spare::boxes, positions);
  int of_obstacle = 0;
  if (bodies.obstacle) {
    const MutualPenetrations mutual =
        mutual_penetrations(bodies.ribbon.surface(), bodies.ribbon.hierarchy(positions),
                            bodies.obstacle->surface, bodies.obstacle->hierarchy, positions);
    of_ribbon.insert(of_ribbon.end(), mutual.edges_of_first.begin(), mutual.edges_of_first.end());
    of_obstacle = distinct_edges(mutual.edges_of_second);
  }
  return distinct_edges(of_ribbon) + of_obstacle;
}

RecoveryReport recover(Bodies& bodies, const RecoverySettings& settings, Matrix3Xd& positions) {
  RecoveryReport report;
  report.penetrating_edges = count_penetrating_edges(bodies, positions);
  bool improves = true;
  while (report.penetrating_edges > 0 && improves) {
    const Matrix3Xd before = positions;
    repeat([&] { return ribbon_into_obstacle(bodies, positions); },
           [&](const std::vector<Penetration>& errors) {
             apply_scheme_a(bodies.grid, bodies.ribbon.surface(), bodies.obstacle->surface, errors,
                            settings.gap_m, positions);
           },
           settings.patience, positions, report.iterations);
    repeat([&] { return border_into_ribbon(bodies, positions); },
           [&](const std::vector<Penetration>& errors) {
             apply_scheme_b(bodies.grid, bodies.ribbon.surface(), errors, settings.step_m,
                            positions);
           },
           settings.patience, positions, report.iterations);
    repeat([&] { return ribbon_into_itself(bodies, positions); },
           [&](const std::vector<Penetration>& errors) {
             apply_scheme_c(bodies.grid, bodies.ribbon.surface(), errors, settings.gap_m,
                            positions);
           },
           settings.patience, positions, report.iterations);
    const int left = count_penetrating_edges(bodies, positions);
    improves = left < report.penetrating_edges;
    if (improves)
      report.penetrating_edges = left;
    else
      positions = before;  // moving out of the obstacle may cost more than it brings
  }
  return report;
}

}  // namespace ribbon
