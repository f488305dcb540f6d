// The lines that a mesh is shown by as a wireframe.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace ribbon {

struct WireEdge {
  Eigen::Vector3f begin;
  Eigen::Vector3f end;
  // Directions that the faces on both sides look to, not of unit length; at a border opposite ones.
  Eigen::Vector3f face;
  Eigen::Vector3f other_face;
};

// Each edge once, also where triangles only repeat each other's vertices. Those that merely split a
// flat face are left out, so that quads are seen as quads.
std::vector<WireEdge> wire_edges(const TriangleMesh& mesh);

}  // namespace ribbon
