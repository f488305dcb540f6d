// Is the ribbon drawn inside the object that it is to be fastened round?
#pragma once

#include "geometry/triangle_mesh.h"
#include "result/result.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/scene.h"

namespace ribbon {

// Has the surface no border, so that it divides space into inside and outside? Corners at one place
// are one, whatever their numbers: files often repeat them.
bool is_closed(const TriangleMesh& mesh);

// Fails, with the scene's name, where the obstacle is closed and the middles of all rows of the
// ribbon lie inside: so does a drawing whose unit is too small.
Result<void> check_outside(const Scene& scene, const RibbonMesh& ribbon,
                           const TriangleMesh& obstacle);

}  // namespace ribbon
