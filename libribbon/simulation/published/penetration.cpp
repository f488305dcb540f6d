#include "simulation/published/penetration.h"

#include <algorithm>
#include <set>

#include "geometry/segment_triangle.h"
#include "parallel/parallel.h"
#include "simulation/detection/vertex_ranges.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// Appends the edges that `edge_triangle` answers for and that pierce `triangle`.
void list_piercing_edges(const CollisionSurface& edges, int edge_triangle,
                         const CollisionSurface& triangles, int triangle,
                         const Matrix3Xd& positions, std::vector<Penetration>& found) {
  const Eigen::Vector3i corners = triangles.triangles.col(triangle);
  for (int corner = 0; corner < 3; ++corner) {
    if (!edges.answers_for_edge(edge_triangle, corner)) continue;
    const int p = edges.triangles(corner, edge_triangle);
    const int q = edges.triangles((corner + 1) % 3, edge_triangle);
    if ((corners.array() == p).any() || (corners.array() == q).any()) continue;
    const Vector3d a = positions.col(corners[0]);
    const Vector3d b = positions.col(corners[1]);
    const Vector3d c = positions.col(corners[2]);
    const auto piercing = pierce(positions.col(p), positions.col(q), a, b, c);
    if (!piercing) continue;
    const auto& w = piercing->weights;
    found.push_back({edges.triangle_edges[static_cast<std::size_t>(edge_triangle)]
                                         [static_cast<std::size_t>(corner)],
                     triangle, w[0] * a + w[1] * b + w[2] * c});
  }
}

// Runs list(pair, found) for all pairs on both cores and joins what was found, in order.
template <class List>
std::vector<Penetration> collect(std::span<const CandidatePair> pairs, const List& list) {
  constexpr std::size_t grain = 512;
  std::vector<std::vector<Penetration>> parts((pairs.size() + grain - 1) / grain);
  parallel_ranges(pairs.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) list(pairs[i], parts[begin / grain]);
  });
  std::vector<Penetration> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

std::vector<Penetration> self_penetrations(const CollisionSurface& surface, Hierarchy& hierarchy,
                                           Hierarchy::Spare spare, const Matrix3Xd& positions) {
  hierarchy.refit(vertex_ranges(positions, positions), 0);
  if (spare == Hierarchy::Spare::curvature_and_boxes)
    hierarchy.refit_curvatures(positions, positions);
  return collect(hierarchy.pairs_within(spare),
                 [&](const CandidatePair& pair, std::vector<Penetration>& found) {
                   list_piercing_edges(surface, pair.a, surface, pair.b, positions, found);
                   list_piercing_edges(surface, pair.b, surface, pair.a, positions, found);
                 });
}

MutualPenetrations mutual_penetrations(const CollisionSurface& first, Hierarchy& first_hierarchy,
                                       const CollisionSurface& second,
                                       const Hierarchy& second_hierarchy,
                                       const Matrix3Xd& positions) {
  first_hierarchy.refit(vertex_ranges(positions, positions), 0);
  const std::vector<CandidatePair> pairs = first_hierarchy.pairs_with(second_hierarchy);
  return {collect(pairs,
                  [&](const CandidatePair& pair, std::vector<Penetration>& found) {
                    list_piercing_edges(first, pair.a, second, pair.b, positions, found);
                  }),
          collect(pairs, [&](const CandidatePair& pair, std::vector<Penetration>& found) {
            list_piercing_edges(second, pair.b, first, pair.a, positions, found);
          })};
}

int distinct_edges(const std::vector<Penetration>& penetrations) {
  std::set<int> edges;
  for (const Penetration& penetration : penetrations) edges.insert(penetration.edge);
  return static_cast<int>(edges.size());
}

}  // namespace ribbon
