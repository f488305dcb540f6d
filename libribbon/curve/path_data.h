// The two small languages inside an SVG file: path data and transforms.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

namespace ribbon {

// The flattened subpaths of some path data.
struct FlatPath {
  // Those that draw something; in each, consecutive points differ.
  std::vector<std::vector<Eigen::Vector2d>> pieces;
  bool closed = false;  // by Z, in any subpath
};

// Reads all path commands of SVG 1.1, maps them by `root_from_path` and flattens curves to within
// `tolerance` (> 0), but to no more than 10 000 chords a curve. Nothing if `data` is malformed.
std::optional<FlatPath> flatten_path_data(const std::string& data,
                                          const Eigen::Affine2d& root_from_path, double tolerance);

// The product of a transform attribute's list; nothing if `text` is malformed.
std::optional<Eigen::Affine2d> read_transform(const std::string& text);

}  // namespace ribbon
