// The edges of meshes as lines.
#pragma once

#include "geometry/ribbon_grid.h"
#include "geometry/triangle_mesh.h"
#include "player/overlay/space_lines.h"

namespace ribbon {

// Between neighbours along and across, without the diagonals; points: 3 x particles.
SpaceLines ribbon_lines(const RibbonGrid& grid, const Eigen::Matrix3Xf& positions);

// Every edge once, also where triangles only repeat each other's vertices.
SpaceLines mesh_lines(const TriangleMesh& mesh);

}  // namespace ribbon
