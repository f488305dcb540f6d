#include "player/overlay/mesh_lines.h"

#include <algorithm>
#include <array>
#include <set>

#include "geometry/first_in_place.h"

namespace ribbon {

SpaceLines ribbon_lines(const RibbonGrid& grid, const Eigen::Matrix3Xf& positions) {
  SpaceLines result{positions, {}};
  for (int i = 0; i < grid.along; ++i)
    for (int j = 0; j < grid.across; ++j) {
      if (i + 1 < grid.along)
        result.lines.push_back({grid.particle(i, j), grid.particle(i + 1, j)});
      if (j + 1 < grid.across)
        result.lines.push_back({grid.particle(i, j), grid.particle(i, j + 1)});
    }
  return result;
}

SpaceLines mesh_lines(const TriangleMesh& mesh) {
  const std::vector<int> first = first_in_place(mesh.vertices);
  std::set<std::array<int, 2>> edges;
  for (const auto& triangle : mesh.triangles.colwise())
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(first[triangle[k]], first[triangle[(k + 1) % 3]]);
      if (a != b) edges.insert({a, b});
    }
  return {mesh.vertices, {edges.begin(), edges.end()}};
}

}  // namespace ribbon
