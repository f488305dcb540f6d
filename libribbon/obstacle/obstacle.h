// The still-life object that the ribbon is fastened around (paper, section 5.1).
#pragma once

#include <optional>

#include "geometry/triangle_mesh.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// Reads any triangle mesh file that assimp reads (of PLY no triangle strips, nor data that begin
// with a line end's byte), joins equal vertices, turns FBX to metres and y up as the file says,
// scales and places it. The vertices are final in single precision, so that the recorded obstacle
// is the simulated one. The mesh may be as bad as it likes: open, non-manifold, with triangles that
// are duplicates, inverted or without area; they are kept, and all are in the ribbon's way. Fails,
// with the place in the scene, when it cannot be read, holds no triangles, or (naming the triangle)
// has coordinates that are not finite.
Result<TriangleMesh> read_obstacle(const ObstacleScene& scene);

// Likewise; nothing where the scene has none.
Result<std::optional<TriangleMesh>> read_obstacle(const Scene& scene);

}  // namespace ribbon
