#include "simulation/start/first_intersection.h"

#include <algorithm>

#include "simulation/published/penetration.h"
#include "simulation/truncation/contact_candidates.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

// A vertex of the edge that pierces, and one of the triangle that is pierced.
int end_of(const CollisionSurface& surface, const Penetration& penetration) {
  return surface.edges[penetration.edge][0];
}
int corner_of(const CollisionSurface& surface, const Penetration& penetration) {
  return surface.triangles(0, penetration.triangle);
}

}  // namespace

std::optional<MeetingPlace> first_intersection(Bodies& bodies, const Matrix3Xd& positions) {
  const CollisionSurface& ribbon = bodies.ribbon.surface();
  TriangleBvh bvh(ribbon, positions);  // asked for rarely: not worth keeping
  const auto within = self_penetrations(ribbon, bvh, TriangleBvh::Spare::boxes, positions);
  if (!within.empty()) {
    const auto [low, high] =
        std::minmax({end_of(ribbon, within.front()), corner_of(ribbon, within.front())});
    return MeetingPlace{low, high};
  }
  if (!bodies.obstacle) return std::nullopt;
  const CollisionSurface& obstacle = bodies.obstacle->surface;
  const auto [of_ribbon, of_obstacle] =
      mutual_penetrations(ribbon, bvh, *bodies.obstacle, positions);
  const int first = bodies.grid.particle_count();
  if (!of_ribbon.empty())
    return MeetingPlace{end_of(ribbon, of_ribbon.front()),
                        first + corner_of(obstacle, of_ribbon.front())};
  if (!of_obstacle.empty())
    return MeetingPlace{corner_of(ribbon, of_obstacle.front()),
                        first + end_of(obstacle, of_obstacle.front())};
  return std::nullopt;
}

std::optional<MeetingPlace> first_closer_than(double distance_m, Bodies& bodies,
                                              const Matrix3Xd& positions) {
  const ContactCandidates near =
      BroadPhase({.reach_m = distance_m, .slack_m = 0, .longest_way_m = 0})
          .detect(bodies, positions, positions, positions);
  for (std::size_t i = 0; i < near.pairs.size(); ++i) {
    if (near.distances_m[i] >= distance_m) continue;
    const auto [low, high] =
        std::minmax(near.pairs[i].vertices.front(), near.pairs[i].vertices.back());
    return MeetingPlace{low, high};
  }
  return std::nullopt;
}

}  // namespace ribbon
