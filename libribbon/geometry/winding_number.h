// Is a point inside a mesh?
#pragma once

#include <Eigen/Core>

#include "geometry/triangle_mesh.h"

namespace ribbon {

// How often the mesh encloses the point: 1 inside a closed one, -1 inside one that is inside out, 0
// outside, and for an open one something between: more than a half within a pipe (Jacobson et al.,
// "Robust inside-outside segmentation using generalized winding numbers", 2013). In double
// precision, not exactly.
double winding_number(const TriangleMesh& mesh, const Eigen::Vector3d& point);

}  // namespace ribbon
