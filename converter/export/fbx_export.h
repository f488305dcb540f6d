// Binary FBX, written by assimp and repaired.
#pragma once

#include <string>

#include "converter/export/model.h"
#include "result/result.h"

namespace ribbon {

// The model as the bytes of a binary FBX file that Blender opens: metres, y up, the recording's
// frame rate, vertices in the model's order, none joined. Fails when assimp cannot write it.
Result<std::string> fbx_bytes(const Model& model);

// What the installed assimp itself makes of the model, before the container is repaired.
Result<std::string> unrepaired_fbx_bytes(const Model& model);

}  // namespace ribbon
