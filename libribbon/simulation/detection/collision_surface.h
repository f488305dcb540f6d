// A triangle surface as collision tests see it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace ribbon {

// Triangles and their distinct edges, over vertices that several surfaces may share. Vertices and
// edges belong to several triangles; each is answered for by exactly one of them, so that a pair of
// features is tested once.
struct CollisionSurface {
  Eigen::Matrix3Xi triangles;                      // 3 x T vertex indices
  std::vector<std::array<int, 2>> edges;           // vertex pairs, the smaller index first
  std::vector<std::array<int, 3>> triangle_edges;  // edge c joins corners c and c+1
  std::vector<std::uint8_t> answers_for;           // bit c: vertex of corner c, bit 3+c: edge c

  [[nodiscard]] bool answers_for_vertex(int triangle, int corner) const {
    return (answers_for[triangle] >> corner & 1) != 0;
  }
  [[nodiscard]] bool answers_for_edge(int triangle, int corner) const {
    return (answers_for[triangle] >> (3 + corner) & 1) != 0;
  }
};

CollisionSurface collision_surface(Eigen::Matrix3Xi triangles);

// The triangles with the first of all vertices at an equal place (3 x vertices) for each corner, so
// that those of several pieces are neighbours. What would lose a side stays as it is.
Eigen::Matrix3Xi with_equal_vertices_joined(Eigen::Matrix3Xi triangles,
                                            const Eigen::Matrix3Xd& vertices);

}  // namespace ribbon
