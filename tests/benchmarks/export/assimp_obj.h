// OBJ as assimp writes it, for comparison.
#pragma once

#include <filesystem>

#include "model/model.h"

namespace ribbon {

// Writes the model to `path`, with assimp's default steps for OBJ, which compute normals.
Result<void> write_obj_by_assimp(const Model& model, const std::filesystem::path& path);

}  // namespace ribbon
