#include "simulation/start/inside_obstacle.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "geometry/first_in_place.h"
#include "geometry/segment_triangle.h"
#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::Vector3d;
using Places = std::array<int, 3>;  // of a triangle's corners, by their first vertex, ascending

// Of each triangle, but for repeated ones and those whose corners are not three places.
std::map<int, Places> triangles_by_place(const TriangleMesh& mesh) {
  const std::vector<int> place = first_in_place(mesh.vertices);
  std::map<int, Places> triangles;
  std::set<Places> known;
  for (int t = 0; t < mesh.triangles.cols(); ++t) {
    Places corners{};
    for (int k = 0; k < 3; ++k) corners[k] = place[mesh.triangles(k, t)];
    std::sort(corners.begin(), corners.end());
    const bool is_flat = corners[0] == corners[1] || corners[1] == corners[2];
    if (!is_flat && known.insert(corners).second) triangles[t] = corners;
  }
  return triangles;
}

// Those that hang together by common places, as numbers of triangles.
std::vector<std::vector<int>> bodies_of(const std::map<int, Places>& triangles) {
  std::map<int, int> parent;
  const auto root = [&](int place) {
    parent.try_emplace(place, place);
    while (parent[place] != place) place = parent[place] = parent[parent[place]];
    return place;
  };
  for (const auto& [triangle, corners] : triangles) {
    parent[root(corners[1])] = root(corners[0]);
    parent[root(corners[2])] = root(corners[0]);
  }
  std::map<int, std::vector<int>> bodies;
  for (const auto& [triangle, corners] : triangles) bodies[root(corners[0])].push_back(triangle);
  std::vector<std::vector<int>> list;
  list.reserve(bodies.size());
  for (auto& [place, body] : bodies) list.push_back(std::move(body));
  return list;
}

// Does an even number of triangles meet at each edge?
bool has_no_border(const std::vector<int>& body, const std::map<int, Places>& triangles) {
  std::map<std::pair<int, int>, int> meeting;
  for (const int triangle : body) {
    const Places& corners = triangles.at(triangle);
    for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 2)})
      ++meeting[{corners[a], corners[b]}];
  }
  return std::all_of(meeting.begin(), meeting.end(),
                     [](const auto& edge) { return edge.second % 2 == 0; });
}

// A line from the point to `far` leaves the body once more than it enters it. Which side of a
// triangle is its front does not matter.
bool leaves_body(const TriangleMesh& mesh, const std::vector<int>& body, const Vector3d& point,
                 const Vector3d& far) {
  const auto corner = [&](int triangle, int k) -> Vector3d {
    return mesh.vertices.col(mesh.triangles(k, triangle)).cast<double>();
  };
  const auto pierced = std::count_if(body.begin(), body.end(), [&](int triangle) {
    return pierce(point, far, corner(triangle, 0), corner(triangle, 1), corner(triangle, 2))
        .has_value();
  });
  return pierced % 2 == 1;
}

// As two of three lines say: one may run along an edge.
bool encloses(const TriangleMesh& mesh, const std::vector<int>& body, const Vector3d& point) {
  double reach_m = 1;
  for (const int triangle : body)
    for (int k = 0; k < 3; ++k) {
      const Vector3d corner = mesh.vertices.col(mesh.triangles(k, triangle)).cast<double>();
      reach_m = std::max(reach_m, length_of((corner - point).eval()));
    }
  int enclosed = 0;
  for (const Vector3d& direction :
       {Vector3d(0.86, 0.31, 0.41), Vector3d(-0.29, 0.91, 0.31), Vector3d(0.23, -0.37, 0.9)})
    enclosed += leaves_body(mesh, body, point, point + 2 * reach_m * direction) ? 1 : 0;
  return enclosed >= 2;
}

// Nothing outside the box around all triangles is inside a body.
bool is_within_box(const TriangleMesh& mesh, const Eigen::Matrix3Xd& points) {
  const Vector3d low = mesh.vertices.rowwise().minCoeff().cast<double>();
  const Vector3d high = mesh.vertices.rowwise().maxCoeff().cast<double>();
  return ((points.colwise() - low).array() >= 0).all() &&
         ((points.colwise() - high).array() <= 0).all();
}

Eigen::Matrix3Xd middles_of_rows(const RibbonMesh& ribbon) {
  const RibbonGrid& grid = ribbon.grid;
  Eigen::Matrix3Xd middles(3, grid.along);
  for (int row = 0; row < grid.along; ++row)
    middles.col(row) =
        mean_of_columns(ribbon.positions.middleCols(grid.particle(row, 0), grid.across));
  return middles;
}

}  // namespace

std::vector<std::vector<int>> closed_bodies(const TriangleMesh& mesh) {
  const auto triangles = triangles_by_place(mesh);
  auto bodies = bodies_of(triangles);
  std::erase_if(bodies, [&](const auto& body) { return !has_no_border(body, triangles); });
  return bodies;
}

Result<void> check_outside(const Scene& scene, const RibbonMesh& ribbon,
                           const TriangleMesh& obstacle) {
  const Eigen::Matrix3Xd middles = middles_of_rows(ribbon);
  if (!is_within_box(obstacle, middles)) return {};
  const auto holds_all = [&](const std::vector<int>& body) {
    const auto points = middles.colwise();
    return std::all_of(points.begin(), points.end(),
                       [&](const auto& middle) { return encloses(obstacle, body, middle); });
  };
  const auto bodies = closed_bodies(obstacle);
  if (std::none_of(bodies.begin(), bodies.end(), holds_all)) return {};
  const bool is_named = scene.obstacle && !scene.obstacle->file.place.empty();
  return failure(is_named ? scene.obstacle->file.place : scene.name,
                 "the ribbon lies inside the obstacle",
                 "is curve.unit right? Otherwise move the ribbon out with curve.origin, or make "
                 "the obstacle smaller with obstacle.scale");
}

}  // namespace ribbon
