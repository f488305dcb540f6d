#include "simulation/start/encounter.h"

#include <algorithm>

#include "simulation/published/penetration.h"
#include "simulation/truncation/surroundings.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

Encounter encounter_of(const CollisionSurface& edges, const CollisionSurface& triangles,
                       const Penetration& penetration) {
  const int of_edge = edges.edges[static_cast<std::size_t>(penetration.edge)][0];
  const int of_triangle = triangles.triangles(0, penetration.triangle);
  // The ribbon's particles come before the obstacle's vertices.
  return {std::min(of_edge, of_triangle), std::max(of_edge, of_triangle)};
}

}  // namespace

std::optional<Encounter> first_piercing(Bodies& bodies, const Matrix3Xd& positions) {
  const CollisionSurface& ribbon = bodies.ribbon.surface();
  Hierarchy hierarchy(ribbon, positions);  // asked for rarely: not worth keeping
  const auto within = self_penetrations(ribbon, hierarchy, Hierarchy::Spare::boxes, positions);
  if (!within.empty()) return encounter_of(ribbon, ribbon, within.front());
  if (!bodies.obstacle) return std::nullopt;
  const CollisionSurface& obstacle = bodies.obstacle->surface;
  const MutualPenetrations mutual =
      mutual_penetrations(ribbon, hierarchy, obstacle, bodies.obstacle->hierarchy, positions);
  if (!mutual.edges_of_first.empty())
    return encounter_of(ribbon, obstacle, mutual.edges_of_first.front());
  if (!mutual.edges_of_second.empty())
    return encounter_of(obstacle, ribbon, mutual.edges_of_second.front());
  return std::nullopt;
}

std::optional<Encounter> first_closer_than(double gap_m, Bodies& bodies,
                                           const Matrix3Xd& positions) {
  const Surroundings near =
      survey(bodies, {.reach_m = gap_m, .slack_m = 0, .longest_way_m = 0}, positions, positions);
  for (std::size_t i = 0; i < near.pairs.size(); ++i) {
    if (near.distances_m[i] >= gap_m) continue;
    const auto [low, high] =
        std::minmax(near.pairs[i].vertices.front(), near.pairs[i].vertices.back());
    return Encounter{low, high};
  }
  return std::nullopt;
}

}  // namespace ribbon
