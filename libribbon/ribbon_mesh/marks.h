// Marks of the drawing, by which a scene tells where hands have the band.
#pragma once

#include <optional>

#include "geometry/triangle_mesh.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// The scene, also its text, with a span for each mark: around the row whose middle lies nearest to
// the mark in the drawing, as long as the band is wide. So a run can go on without its drawing.
// Fails, with the place in the scene, where the drawing has no such mark, and where two parts of
// the band are about as near to it. obstacle: that of the scene.
Result<Scene> with_marks_found(const Scene& scene,
                               const std::optional<TriangleMesh>& obstacle = std::nullopt);

}  // namespace ribbon
