// glTF in one binary file: the ribbon's motion as morph targets, one for each frame.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "model/motion_writer.h"

namespace ribbon {

// glTF 2.0, in metres and y up, as it demands. The ribbon's mesh is the first frame; each further
// frame is a target that moves every vertex there, and an animation gives it the weight 1 at its
// time and passes linearly from one frame to the next. Written frame by frame; what is held in
// memory grows with the motion by three quarters of a kilobyte a frame. Fails where the frames
// would not fit into the 4 GB that the format allows, or are more than 65 536.
Result<std::unique_ptr<MotionWriter>> new_glb_writer(const std::filesystem::path& path,
                                                     const Model& model, int frames);

// What is known to go wrong with so many frames at this frame rate; mostly nothing.
std::string glb_warning(const Model& model, int frames);

}  // namespace ribbon
