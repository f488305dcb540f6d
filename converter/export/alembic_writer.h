// Alembic: ribbon and obstacle with everything but their materials, for Maya, Houdini and Blender.
#pragma once

#include <filesystem>
#include <memory>

#include "model/motion_writer.h"

namespace ribbon {

// An Ogawa file as Alembic 1.8.5 writes it: per object a transformation (the identity) with the
// object's name and below it a mesh. Faces, clockwise, and uv stand in it once, positions,
// bounds and normals, if there are any, for every frame. Sample f is at f / frames_per_second
// seconds. docs/export.md has the layout.
Result<std::unique_ptr<MotionWriter>> new_alembic_writer(const std::filesystem::path& path,
                                                         const Model& model, int frames);

}  // namespace ribbon
