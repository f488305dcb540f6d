// The user's drawing as a polyline.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "result/result.h"

namespace ribbon {

// A drawn polyline in drawing units, y down as in SVG: consecutive points differ, at least 2.
using Drawing = std::vector<Eigen::Vector2d>;

// Reads one open path (or polyline or line) from an SVG file as drawing programs write it, all
// transforms applied, curves flattened to within `tolerance` (> 0) drawing units. Those are the
// user units of the root element: its viewBox, width and height are not applied. `path_id` chooses
// among several paths; empty: exactly one must be visible; hidden ones, <defs>, symbols, markers
// and nested <svg> do not count. Fails with file and line when there is no such path, or it is
// closed, empty or made of several pieces, or lies beyond 1e9 units.
Result<Drawing> read_svg_path(const std::filesystem::path& file, const std::string& path_id,
                              double tolerance);

}  // namespace ribbon
