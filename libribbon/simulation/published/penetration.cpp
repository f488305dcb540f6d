#include "simulation/published/penetration.h"

#include <set>

#include "geometry/segment_triangle.h"
#include "parallel/parallel.h"
#include "simulation/detection/vertex_ranges.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// A surface and where its vertices are.
struct PlacedSurface {
  const CollisionSurface& surface;
  const Matrix3Xd& positions;
};

// Appends the edges that `edge_triangle` answers for and that pierce `triangle`. Edges touch the
// triangles of their own surface with which they share a vertex, and do not pierce them.
void list_piercing_edges(const PlacedSurface& edges, int edge_triangle,
                         const PlacedSurface& triangles, int triangle,
                         std::vector<Penetration>& found) {
  const bool is_one_surface = &edges.surface == &triangles.surface;
  const Eigen::Vector3i corners = triangles.surface.triangles.col(triangle);
  for (int corner = 0; corner < 3; ++corner) {
    if (!edges.surface.answers_for_edge(edge_triangle, corner)) continue;
    const int p = edges.surface.triangles(corner, edge_triangle);
    const int q = edges.surface.triangles((corner + 1) % 3, edge_triangle);
    if (is_one_surface && ((corners.array() == p).any() || (corners.array() == q).any())) continue;
    const Vector3d a = triangles.positions.col(corners[0]);
    const Vector3d b = triangles.positions.col(corners[1]);
    const Vector3d c = triangles.positions.col(corners[2]);
    const auto piercing = pierce(edges.positions.col(p), edges.positions.col(q), a, b, c);
    if (!piercing) continue;
    const auto& w = piercing->weights;
    found.push_back({edges.surface.triangle_edges[edge_triangle][corner], triangle,
                     w[0] * a + w[1] * b + w[2] * c});
  }
}

// Runs list(pair, found) for all pairs on all cores and joins what was found, in order.
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

std::vector<Penetration> self_penetrations(const CollisionSurface& ribbon, TriangleBvh& bvh,
                                           TriangleBvh::Spare spare, const Matrix3Xd& positions) {
  bvh.refit(vertex_ranges(positions, positions), 0);
  if (spare == TriangleBvh::Spare::curvature_and_boxes) bvh.refit_curvatures(positions, positions);
  const PlacedSurface placed{ribbon, positions};
  return collect(bvh.pairs_within(spare),
                 [&](const CandidatePair& pair, std::vector<Penetration>& found) {
                   list_piercing_edges(placed, pair.a, placed, pair.b, found);
                   list_piercing_edges(placed, pair.b, placed, pair.a, found);
                 });
}

MutualPenetrations mutual_penetrations(const CollisionSurface& ribbon, TriangleBvh& bvh,
                                       const ObstacleBody& obstacle, const Matrix3Xd& positions) {
  bvh.refit(vertex_ranges(positions, positions), 0);
  const std::vector<CandidatePair> pairs = bvh.pairs_with(obstacle.bvh);
  const PlacedSurface moving{ribbon, positions};
  const PlacedSurface still{obstacle.surface, obstacle.vertices};
  return {collect(pairs,
                  [&](const CandidatePair& pair, std::vector<Penetration>& found) {
                    list_piercing_edges(moving, pair.a, still, pair.b, found);
                  }),
          collect(pairs, [&](const CandidatePair& pair, std::vector<Penetration>& found) {
            list_piercing_edges(still, pair.b, moving, pair.a, found);
          })};
}

int distinct_edges(const std::vector<Penetration>& penetrations) {
  std::set<int> edges;
  for (const Penetration& penetration : penetrations) edges.insert(penetration.edge);
  return static_cast<int>(edges.size());
}

}  // namespace ribbon
