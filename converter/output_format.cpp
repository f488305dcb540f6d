#include "converter/output_format.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "commandline/extension.h"
#include "converter/motion_format.h"

namespace ribbon {

namespace {

// What assimp 5.2.5 does to a ribbon in the formats that it says it writes; measured.
constexpr std::array<std::pair<std::string_view, const char*>, 6> refused{{
    {".gltf", "its binary form is .glb"},
    {".ply", "assimp merges ribbon and obstacle, and the format does not say which way is up"},
    {".stl", "the format has no uv and no shared vertices"},
    {".3mf", "assimp loses the fourth corner of every quad"},
    {".x3d", "Blender finds no mesh in assimp's file"},
    {".usd", "its text form is .usda"},
}};

std::string problem_of(const std::string& extension) {
  if (extension.empty()) return "has no extension that tells the format";
  const auto* found = std::find_if(refused.begin(), refused.end(), [&](const auto& entry) {
    return extension.starts_with(entry.first);
  });
  return "is not written as " + extension +
         (found == refused.end() ? "" : std::string(" (") + found->second + ")");
}

std::string supported() {
  std::string motions;
  for (const MotionFormat& format : motion_formats())
    motions += (motions.empty() ? "" : ", ") + std::string(format.extension);
  return "choose .obj or .fbx (one file a frame), " + motions +
         " (all frames in one file), .csv (the numbers of each frame) or .rbn (a recording)";
}

}  // namespace

Result<OutputFormat> output_format(const std::string& output) {
  const std::string extension = lower_case_extension(output);
  if (extension == ".obj") return OutputFormat::obj;
  if (extension == ".fbx") return OutputFormat::fbx;
  if (extension != ".csv" && extension != ".rbn" && motion_format(output) == nullptr)
    return failure(output, problem_of(extension), supported());
  if (output.find('{') != std::string::npos)
    return failure(output, "a " + extension + " file holds all frames", "leave {frame} out");
  if (extension == ".csv") return OutputFormat::numbers;
  return extension == ".rbn" ? OutputFormat::recording : OutputFormat::whole_motion;
}

}  // namespace ribbon
