// USD in its text form: ribbon and obstacle with materials, for Houdini, Maya, Omniverse and
// Blender.
#pragma once

#include <filesystem>
#include <memory>

#include "model/motion_writer.h"

namespace ribbon {

// One Mesh for each object below the prim World, with points for every frame where it moves, and a
// Material for each. The time codes are the frames from 0; how many pass in a second, the unit and
// the upward axis are told. What a prim's name cannot hold is kept as its displayName.
Result<std::unique_ptr<MotionWriter>> new_usd_writer(const std::filesystem::path& path,
                                                     const Model& model, int frames);

}  // namespace ribbon
