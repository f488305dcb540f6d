#include "converter/output_format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <utility>

namespace ribbon {

namespace {

constexpr const char* supported =
    "choose .obj or .fbx (one file a frame), .pc2 (all frames in one file) or .rbn (a recording)";

// What assimp 5.2.5 does to a ribbon in the formats that it says it writes; measured.
constexpr std::array<std::pair<std::string_view, const char*>, 8> refused{{
    {".glb", "assimp splits the quads and joins vertices"},
    {".gltf", "assimp splits the quads and joins vertices"},
    {".ply", "assimp merges ribbon and obstacle, and the format does not say which way is up"},
    {".stl", "the format has no uv and no shared vertices"},
    {".3mf", "assimp loses the fourth corner of every quad"},
    {".x3d", "Blender finds no mesh in assimp's file"},
    {".abc", "assimp does not write it"},
    {".usd", "assimp does not write it"},
}};

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string problem_of(const std::string& extension) {
  if (extension.empty()) return "has no extension that tells the format";
  const auto* found = std::find_if(refused.begin(), refused.end(), [&](const auto& entry) {
    return extension.starts_with(entry.first);
  });
  return "is not written as " + extension +
         (found == refused.end() ? "" : std::string(" (") + found->second + ")");
}

}  // namespace

Result<OutputFormat> output_format(const std::string& output) {
  const std::string extension = lower_case(std::filesystem::path(output).extension().string());
  if (extension == ".obj") return OutputFormat::obj;
  if (extension == ".fbx") return OutputFormat::fbx;
  if (extension == ".pc2") return OutputFormat::pc2;
  if (extension == ".rbn") return OutputFormat::recording;
  return failure(output, problem_of(extension), supported);
}

}  // namespace ribbon
