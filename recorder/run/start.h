// From a scene to a ribbon that can be fastened.
#pragma once

#include <optional>

#include "geometry/centre_axis.h"
#include "geometry/triangle_mesh.h"
#include "result/result.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/scene.h"
#include "simulation/fastening_processor.h"

namespace ribbon {

struct Start {
  RibbonMesh ribbon;  // as generated
  FasteningProcessor fastening;
};

// Generates the ribbon from its drawing and finds its start, which may take minutes and tells the
// observer. Fails when the drawing or the start does not work, when the drawing is not the knot
// that the scene expects, and when the start is not the knot that was drawn.
Result<Start> find_start(const Scene& scene, const std::optional<TriangleMesh>& obstacle,
                         const StartObserver& observer = {});

// Nothing without a fastening.
std::optional<CentreAxis> centre_axis(const Scene& scene);

}  // namespace ribbon
