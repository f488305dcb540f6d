// A scene as a page takes it in.
#pragma once

#include <string>

#include "result/result.h"
#include "scene/scene.h"
#include "text/json.h"

namespace ribbon {

// Its `file`, `text` (with widths in place of an outline, whose drawing the page does not have) and
// `name`, its drawing (`points`, x and y in turn, drawing units, and `letters`, as [curve]
// crossings has them, empty where there are none), how that lies in the world (`unit_m`, `origin`),
// the ribbon (`width_m`, 0 where its rows are not all as wide, `along`, `across`) and, where there
// is one, the `object`: `file`, `name`, and of a TriangleMesh `vertices` and `triangles`, three
// numbers each. Fails where drawing, outline or object cannot be read.
Result<Json> scene_json(const Scene& wanted);

}  // namespace ribbon
