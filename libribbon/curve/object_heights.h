// The object as who draws round it sees it.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "geometry/lines_of_sight.h"
#include "geometry/triangle_mesh.h"
#include "scene/scene.h"

namespace ribbon {

// From its lowest to its highest place on the line of sight through a place of the drawing; nothing
// where the line misses it. All in drawing units, heights above the drawing's plane.
using ObjectHeights = std::function<std::optional<HeightRange>(const Eigen::Vector2d& place)>;

// Of an object and a scene that live as long. An empty function where there is no object.
ObjectHeights heights_of(const std::optional<TriangleMesh>& object, const CurveScene& scene);

}  // namespace ribbon
