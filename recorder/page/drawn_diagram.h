// What a drawing is, as a knot diagram: for who draws it and looks at it meanwhile.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// JSON:
// - crossings: in the order of their first passages: the place `at` [x, y] in drawing units,
//   `first` and `second`, where the walk meets it (polyline parameters), `first_over`
// - passes: of the object, likewise: `begin` and `end` (polyline parameters), the place `at` which
//   they begin, `in_front`
// - letters: the list of crossings; with F and B where the scene tells of the object
// - knot: its name; empty where over and under cannot be told
// - problem: why they cannot, or what else is in the way of tying; empty where nothing is
//
// Where over and under cannot be told, all first passages are over; likewise all passes are in
// front. Fails, with the place in the drawing, where it is no diagram.
Result<std::string> diagram_json(const Scene& scene, const std::optional<TriangleMesh>& obstacle);

// The object's triangles as who draws sees them: x and y of three corners each, in drawing units.
std::vector<float> silhouette(const TriangleMesh& obstacle, const CurveScene& curve);

}  // namespace ribbon
