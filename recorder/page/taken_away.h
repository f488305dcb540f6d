// What of a recording is taken away from a page: the files that ribbon-convert makes of it, too.
#pragma once

#include <filesystem>

#include "geometry/triangle_mesh.h"
#include "result/result.h"

namespace ribbon {

// One frame (from 0): ribbon and object as OBJ, and the materials of both beside it, as `file` with
// .mtl. Fails where the frame cannot be read.
Result<void> write_shape(const std::filesystem::path& recording, int frame,
                         const std::filesystem::path& file);

// All frames that can be read, as glTF in one file. Fails where none can be.
Result<void> write_motion(const std::filesystem::path& recording,
                          const std::filesystem::path& file);

// The object alone, as OBJ without materials: read again, it has the same vertices.
Result<void> write_object(const TriangleMesh& object, const std::filesystem::path& file);

}  // namespace ribbon
