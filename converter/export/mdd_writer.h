// MDD: the positions of the ribbon in every frame, a point cache for a mesh of its own file.
#pragma once

#include <filesystem>
#include <memory>

#include "model/motion_writer.h"

namespace ribbon {

// Layout (big-endian): i32 frames, i32 points, per frame f32 its time in seconds (the first at 0),
// then per frame and point 3 x f32.
Result<std::unique_ptr<MotionWriter>> new_mdd_writer(const std::filesystem::path& path,
                                                     const Model& model, int frames);

}  // namespace ribbon
