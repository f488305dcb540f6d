// Meshes from formulas.
#pragma once

#include <cmath>
#include <numbers>

#include "geometry/triangle_mesh.h"

namespace ribbon {

// An upright prism about the axis y, from low_m to high_m, with or without its two ends.
inline TriangleMesh post(double radius_m, double low_m, double high_m, bool closed = true) {
  constexpr int sides = 24;
  TriangleMesh mesh{"post", Eigen::Matrix3Xf(3, 2 * sides + 2), Eigen::Matrix3Xi(3, 4 * sides)};
  const auto put = [&](int index, double x, double y, double z) {
    mesh.vertices.col(index) = Eigen::Vector3d(x, y, z).cast<float>();
  };
  put(2 * sides, 0, low_m, 0);
  put(2 * sides + 1, 0, high_m, 0);
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    put(2 * k, radius_m * std::sin(angle), low_m, radius_m * std::cos(angle));
    put(2 * k + 1, radius_m * std::sin(angle), high_m, radius_m * std::cos(angle));
    const int low = 2 * k;
    const int next = 2 * ((k + 1) % sides);
    mesh.triangles.col(4 * k) << low, next, low + 1;
    mesh.triangles.col(4 * k + 1) << next, next + 1, low + 1;
    mesh.triangles.col(4 * k + 2) << next, low, 2 * sides;
    mesh.triangles.col(4 * k + 3) << low + 1, next + 1, 2 * sides + 1;
  }
  if (closed) return mesh;
  TriangleMesh pipe = mesh;
  pipe.triangles.resize(3, 2 * sides);
  for (int k = 0; k < sides; ++k)
    pipe.triangles.middleCols(2 * k, 2) = mesh.triangles.middleCols(4 * k, 2);
  return pipe;
}

}  // namespace ribbon
