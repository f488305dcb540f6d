// Marks of the drawing, by which a scene tells where hands have the band.
#pragma once

#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// The scene, also its text, with a span for each mark: around the row whose middle lies nearest to
// the mark in the drawing, as long as the band is wide. So a run can go on without its drawing.
// Fails, with the place in the scene, where the drawing has no such mark, and where two parts of
// the band are about as near to it.
Result<Scene> with_marks_found(const Scene& scene);

}  // namespace ribbon
