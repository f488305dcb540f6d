// A triangle mesh as every station exchanges it.
#pragma once

#include <Eigen/Core>
#include <string>

namespace ribbon {

// vertices: 3 x V in metres, y up. triangles: 3 x T vertex indices, counter-clockwise seen from
// outside.
struct TriangleMesh {
  std::string name;
  Eigen::Matrix3Xf vertices;
  Eigen::Matrix3Xi triangles;
};

}  // namespace ribbon
