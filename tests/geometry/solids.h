// Meshes from formulas.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "geometry/triangle_mesh.h"

namespace ribbon {

// An upright prism about the axis y, open at both ends, its outside outwards. Its corners lie low
// and high by turns.
inline TriangleMesh tube(double radius_m, double low_m, double high_m, int sides = 24) {
  TriangleMesh mesh{"post", Eigen::Matrix3Xf(3, 2 * sides), Eigen::Matrix3Xi(3, 2 * sides)};
  for (int s = 0; s < sides; ++s) {
    const double angle = 2 * std::numbers::pi * s / sides;
    const int low = 2 * s;
    const int next = 2 * ((s + 1) % sides);
    for (int end = 0; end < 2; ++end)
      mesh.vertices.col(low + end) << static_cast<float>(radius_m * std::sin(angle)),
          static_cast<float>(end == 0 ? low_m : high_m),
          static_cast<float>(radius_m * std::cos(angle));
    mesh.triangles.col(low) << low, next, next + 1;
    mesh.triangles.col(low + 1) << low, next + 1, low + 1;
  }
  return mesh;
}

// A tube with a lid at either end, a fan round its first corner.
inline TriangleMesh closed(TriangleMesh tube) {
  const Eigen::Index wall = tube.triangles.cols();
  const int sides = static_cast<int>(wall / 2);
  tube.triangles.conservativeResize(3, wall + 2L * (sides - 2));
  for (int s = 1; s + 1 < sides; ++s) {
    tube.triangles.col(wall + 2L * (s - 1)) << 0, 2 * (s + 1), 2 * s;
    tube.triangles.col(wall + 2L * (s - 1) + 1) << 1, 2 * s + 1, 2 * (s + 1) + 1;
  }
  return tube;
}

// Two triangles with the given corners, counter-clockwise about their front.
inline TriangleMesh quad_mesh(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                              const Eigen::Vector3f& c, const Eigen::Vector3f& d) {
  TriangleMesh mesh{"quad", Eigen::Matrix3Xf(3, 4), Eigen::Matrix3Xi(3, 2)};
  mesh.vertices << a, b, c, d;
  mesh.triangles << 0, 0, 1, 2, 2, 3;
  return mesh;
}

inline TriangleMesh together(const TriangleMesh& first, const TriangleMesh& second) {
  TriangleMesh mesh = first;
  const Eigen::Index vertices = first.vertices.cols();
  mesh.vertices.conservativeResize(3, vertices + second.vertices.cols());
  mesh.vertices.rightCols(second.vertices.cols()) = second.vertices;
  mesh.triangles.conservativeResize(3, first.triangles.cols() + second.triangles.cols());
  mesh.triangles.rightCols(second.triangles.cols()) =
      second.triangles.array() + static_cast<int>(vertices);
  return mesh;
}

}  // namespace ribbon
