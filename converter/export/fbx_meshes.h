// Meshes as records of an FBX file.
#pragma once

#include <vector>

#include "converter/export/fbx_arrays.h"
#include "converter/export/fbx_record.h"
#include "model/model.h"

namespace ribbon {

// Geometry, node, materials and their pictures of the model's object with this index.
std::vector<FbxRecord> fbx_mesh_records(const Model& model, int object, FbxArrays& arrays);
std::vector<FbxRecord> fbx_mesh_connections(const Model& model, int object);

}  // namespace ribbon
