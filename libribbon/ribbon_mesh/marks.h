// Marks and paths of the drawing, by which a scene tells where hands have the band and carry it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "result/result.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/scene.h"

namespace ribbon {

// Does it name marks or paths of its drawing?
bool names_marks(const Scene& scene);

// The scene, also its text, with shares of the band's length for each mark that it names: those of
// the row whose middle lies nearest to the mark in the drawing and, for a hand, of as much around
// it as the band is wide; and with points for each path on which a hand carries the band. So a run
// can go on without its drawing. Fails, with the place in the scene, where the drawing has no such
// mark or path, and where two parts of the band are about as near to a mark. obstacle: that of the
// scene.
Result<Scene> with_marks_found(const Scene& scene,
                               const std::optional<TriangleMesh>& obstacle = std::nullopt);

struct PlacedMark {
  std::string id;
  double share;  // of the band's length, from the end where its path begins
};

// All marks of the drawing that can be told, in the order of the file.
std::vector<PlacedMark> marks_on(const CurveScene& curve, const RibbonMesh& ribbon);

}  // namespace ribbon
