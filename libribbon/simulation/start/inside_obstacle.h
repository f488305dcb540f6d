// Is the ribbon drawn inside the object that it is to be fastened round?
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"
#include "result/result.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/scene.h"

namespace ribbon {

// The parts of the mesh that hang together and have no border, so that each divides space into
// inside and outside, as numbers of triangles. Corners at one place are one, whatever their
// numbers, for files often repeat them; triangles that are repeated count once, and which side of
// them is the front does not matter.
std::vector<std::vector<int>> closed_bodies(const TriangleMesh& mesh);

// Fails, with the scene's place of the obstacle, where a closed body of it holds the middles of all
// rows of the ribbon: so does one whose drawing has too small a unit. A ribbon in the hollow of a
// body is inside it, too; one inside an open mesh is not, for it could be led out.
Result<void> check_outside(const Scene& scene, const RibbonMesh& ribbon,
                           const TriangleMesh& obstacle);

}  // namespace ribbon
