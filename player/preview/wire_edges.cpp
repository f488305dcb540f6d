#include "player/preview/wire_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <utility>

#include "geometry/first_in_place.h"

namespace ribbon {

namespace {

constexpr float flat = 0.99996F;  // cosine of half a degree

// A side of a triangle: the vertices at its ends, the smaller one first.
struct Side {
  std::array<int, 2> ends;
  int triangle;
};

// Those of the same edge next to each other.
std::vector<Side> sides_by_edge(const TriangleMesh& mesh) {
  const std::vector<int> first = first_in_place(mesh.vertices);
  std::vector<Side> sides;
  sides.reserve(static_cast<std::size_t>(mesh.triangles.size()));
  for (int t = 0; t < mesh.triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] =
          std::minmax({first[mesh.triangles(k, t)], first[mesh.triangles((k + 1) % 3, t)]});
      if (a != b) sides.push_back({{a, b}, t});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::pair(a.ends, a.triangle) < std::pair(b.ends, b.triangle);
  });
  return sides;
}

Eigen::Vector3f face_of(const TriangleMesh& mesh, int triangle) {
  const Eigen::Vector3i corners = mesh.triangles.col(triangle);
  const Eigen::Vector3f a = mesh.vertices.col(corners[0]);
  return (mesh.vertices.col(corners[1]) - a).cross(mesh.vertices.col(corners[2]) - a).normalized();
}

}  // namespace

std::vector<WireEdge> wire_edges(const TriangleMesh& mesh) {
  std::vector<WireEdge> edges;
  const std::vector<Side> sides = sides_by_edge(mesh);
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    const Side& side = sides[begin];
    while (end < sides.size() && sides[end].ends == side.ends) ++end;
    const bool between_two = end - begin == 2;
    const Eigen::Vector3f face = face_of(mesh, side.triangle);
    const Eigen::Vector3f other =
        between_two ? face_of(mesh, sides[begin + 1].triangle) : Eigen::Vector3f(-face);
    if (between_two && face.dot(other) > flat) continue;
    edges.push_back(
        {mesh.vertices.col(side.ends[0]), mesh.vertices.col(side.ends[1]), face, other});
  }
  return edges;
}

}  // namespace ribbon
