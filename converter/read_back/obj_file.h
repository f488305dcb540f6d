// Wavefront OBJ, read by tinyobjloader.
#pragma once

#include <filesystem>
#include <memory>

#include "converter/read_back/written_motion.h"

namespace ribbon {

// One frame. Each object's vertices are those between its `o` and the next; a uv belongs to the
// vertex of the same number. Throws Spoiled.
std::unique_ptr<WrittenMotion> read_obj(const std::filesystem::path& path);

}  // namespace ribbon
