// Binary FBX with meshes, of which the first may have blend shapes.
#pragma once

#include <filesystem>
#include <memory>

#include "converter/read_back/written_motion.h"

namespace ribbon {

// The first mesh is the first frame; a shape is the frame in which the curve of its channel is 100.
// Throws Spoiled.
std::unique_ptr<WrittenMotion> read_fbx_file(const std::filesystem::path& path);

}  // namespace ribbon
