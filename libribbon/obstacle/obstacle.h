// The still-life object that the ribbon is fastened around (paper, section 5.1).
#pragma once

#include "geometry/triangle_mesh.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// Reads any triangle mesh file that assimp reads, joins equal vertices, scales and places it. The
// vertices are final in single precision, so that the recorded obstacle is the simulated one. Fails
// with the file's name when it cannot be read, holds no triangles, or has coordinates that are not
// finite.
Result<TriangleMesh> read_obstacle(const ObstacleScene& scene);

}  // namespace ribbon
