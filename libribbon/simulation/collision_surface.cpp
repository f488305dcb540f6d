#include "simulation/collision_surface.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace ribbon {

CollisionSurface collision_surface(Eigen::Matrix3Xi triangles) {
  CollisionSurface surface;
  surface.triangles = std::move(triangles);
  std::map<std::array<int, 2>, int> edge_of;
  std::set<int> vertices_seen;
  for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
    std::array<int, 3> edges{};
    unsigned answers = 0;
    for (int corner = 0; corner < 3; ++corner) {
      const int a = surface.triangles(corner, t);
      const int b = surface.triangles((corner + 1) % 3, t);
      if (vertices_seen.insert(a).second) answers |= 1U << corner;
      const auto [found, is_new] = edge_of.try_emplace(
          std::array<int, 2>{std::min(a, b), std::max(a, b)}, static_cast<int>(edge_of.size()));
      if (is_new) {
        answers |= 1U << (3 + corner);
        surface.edges.push_back(found->first);
      }
      edges[static_cast<std::size_t>(corner)] = found->second;
    }
    surface.triangle_edges.push_back(edges);
    surface.answers_for.push_back(static_cast<std::uint8_t>(answers));
  }
  return surface;
}

}  // namespace ribbon
