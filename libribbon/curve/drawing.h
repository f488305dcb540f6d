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

// Reads one open path from an SVG file as drawing programs write it, all transforms applied, curves
// flattened to within `tolerance` drawing units. `path_id` chooses among several paths; empty: the
// file must hold exactly one. Fails with file and line when there is no such path, or it is closed,
// empty or made of several pieces.
Result<Drawing> read_svg_path(const std::filesystem::path& file, const std::string& path_id,
                              double tolerance);

}  // namespace ribbon
