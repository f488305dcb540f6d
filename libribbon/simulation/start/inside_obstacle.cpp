#include "simulation/start/inside_obstacle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "geometry/vectors.h"
#include "geometry/winding_number.h"

namespace ribbon {

namespace {

// For each vertex the number of its place.
std::vector<int> places_of(const Eigen::Matrix3Xf& vertices) {
  std::map<std::array<float, 3>, int> places;
  std::vector<int> numbers;
  for (const auto& vertex : vertices.colwise()) {
    const int next = static_cast<int>(places.size());
    numbers.push_back(places.try_emplace({vertex[0], vertex[1], vertex[2]}, next).first->second);
  }
  return numbers;
}

}  // namespace

// An edge between two triangles is run through once in either direction.
bool is_closed(const TriangleMesh& mesh) {
  const std::vector<int> place = places_of(mesh.vertices);
  std::map<std::pair<int, int>, int> surplus;  // of an edge's runs from its lower to its higher end
  for (const auto& triangle : mesh.triangles.colwise())
    for (int corner = 0; corner < 3; ++corner) {
      const int from = place[triangle[corner]];
      const int to = place[triangle[(corner + 1) % 3]];
      if (from < to) ++surplus[{from, to}];
      if (to < from) --surplus[{to, from}];
    }
  return std::all_of(surplus.begin(), surplus.end(),
                     [](const auto& edge) { return edge.second == 0; });
}

Result<void> check_outside(const Scene& scene, const RibbonMesh& ribbon,
                           const TriangleMesh& obstacle) {
  const RibbonGrid& grid = ribbon.grid;
  const auto is_inside = [&](int row) {
    const Eigen::Vector3d middle =
        mean_of_columns(ribbon.positions.middleCols(grid.particle(row, 0), grid.across));
    return std::abs(winding_number(obstacle, middle)) > 0.5;
  };
  if (!is_closed(obstacle)) return {};
  for (int row = 0; row < grid.along; ++row)
    if (!is_inside(row)) return {};
  return failure(scene.name, "the ribbon lies inside the obstacle",
                 "is curve.unit right? Otherwise move the ribbon out with curve.origin, or make "
                 "the obstacle smaller with obstacle.scale");
}

}  // namespace ribbon
