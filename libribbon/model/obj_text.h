// Wavefront OBJ and its material library, as text.
#pragma once

#include <string>

#include "model/model.h"

namespace ribbon {

// The model as OBJ: one `o` per object, vertices in the model's order, none joined, `vt` per vertex
// where the object has uv, `vn` likewise, faces as they are. Numbers are the shortest that read
// back as the same float. `material_library` is the file name that `mtllib` refers to; where it is
// empty, no face has a material.
//
// assimp's own OBJ writer is not used: it joins vertices at equal positions (their number then
// changes from frame to frame), orders them by first use, and writes `g`, which Blender imports as
// one single object.
std::string obj_text(const Model& model, const std::string& material_library);

// The materials of all objects as MTL; the same for every frame.
std::string material_library_text(const Model& model);

}  // namespace ribbon
