// glTF as one binary file.
#pragma once

#include <filesystem>
#include <memory>

#include "converter/read_back/written_motion.h"

namespace ribbon {

// One node for each mesh, with one primitive of triangles; the first may have morph targets, each
// of which shows alone at one time of the animation. Throws Spoiled.
std::unique_ptr<WrittenMotion> read_glb(const std::filesystem::path& path);

}  // namespace ribbon
