// The user's drawing as a polyline.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

#include "result/result.h"

namespace ribbon {

// A drawn polyline in drawing units, y down as in SVG: consecutive points differ, at least 2.
using Drawing = std::vector<Eigen::Vector2d>;

// Where a stroke lies, if the drawing says so.
enum class Depth { untold, front, behind };

// A path as it stands in an SVG file.
struct SvgPath {
  std::string place;  // file and line
  std::string name;   // "path 'band'"
  std::string data;   // path data, as of a `d` attribute
  Eigen::Affine2d root_from_path;
  // By the class "front" or "behind" of the path or of a group that it is in; a dashed stroke among
  // others that are not lies behind.
  Depth depth = Depth::untold;
};

// The key of a scene that chooses a path, for remedies.
struct PathKey {
  std::string table = "[curve]";
  std::string key = "path";
};

// Finds a path (or polyline or line) in an SVG file as drawing programs write it, or all of a
// group. `id` chooses among several; empty: exactly one must be visible; hidden ones, <defs>,
// symbols, markers and nested <svg> do not count. Fails with file and line when there is no such
// path.
Result<std::vector<SvgPath>> find_svg_paths(const std::filesystem::path& file,
                                            const std::string& id, const PathKey& key = {});

// Its pieces, all transforms applied, curves flattened to within `tolerance` (> 0) drawing units.
// Those are the user units of the root element: its viewBox, width and height are not applied.
// Fails with the path's place when it is malformed, closed or empty, or lies beyond 1e9 units.
Result<std::vector<Drawing>> flattened(const SvgPath& path, double tolerance);

// Likewise, of a path that is one closed line: its corners, from the last of which it leads back to
// the first. Fails, with the path's place, where it is open or has several pieces.
Result<Drawing> flattened_outline(const SvgPath& path, double tolerance);

// A circle that is not hidden and has an id: a place in the drawing that a scene can name.
struct DrawnMark {
  std::string id;
  // Drawing units, all transforms applied. Fails, with the circle's place, where it cannot be read
  // or lies beyond 1e9 units.
  Result<Eigen::Vector2d> middle;
};

// In document order. Fails where the file cannot be read.
Result<std::vector<DrawnMark>> find_svg_marks(const std::filesystem::path& file);

// The diagonal of the box around it.
double extent_of(const Drawing& drawing);

}  // namespace ribbon
