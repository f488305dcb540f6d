// Binary FBX: one frame, or the ribbon's whole motion as blend shapes.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "model/motion_writer.h"

namespace ribbon {

// FBX 7.4 in metres, with axes and frame rate said in the file; coordinates in double precision,
// vertices in the model's order, none joined. The ribbon's mesh is the first frame; each further
// frame is a blend shape whose channel has the weight 100 at its time and is 0 at the frames beside
// it. Written frame by frame; what is held
// in memory grows with the motion by a third of a kilobyte a frame. append() fails beyond the 4 GB
// that the format allows.
Result<std::unique_ptr<MotionWriter>> new_fbx_writer(const std::filesystem::path& path,
                                                     const Model& model, int frames);

// The model as it is, without motion: the bytes of a file of its own. Fails beyond 4 GB.
Result<std::string> fbx_bytes(const Model& model);

// What is known to go wrong in other programs with so many frames, or at this frame rate: one
// sentence each; mostly none.
std::string fbx_warning(const Model& model, int frames);

}  // namespace ribbon
