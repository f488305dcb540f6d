// The files that a conversion writes, by name.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "result/result.h"

namespace ribbon {

// The file of the frame with this number (from 1).
using FrameFile = std::function<std::filesystem::path(int number)>;

// `output` with its {frame} filled in. A single frame needs none; for more it must be there.
Result<FrameFile> frame_files(const std::string& output, int frame_count);

// The material library that all frames of `output` share, without its folder: what is left of the
// name without {frame} and the separators around it ("knot.{frame:04}.obj": "knot.mtl"; nothing
// left: "ribbon.mtl").
std::string material_library_name(const std::string& output);

}  // namespace ribbon
