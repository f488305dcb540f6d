// PC2: the positions of the ribbon in every frame, a point cache for a mesh of its own file.
#pragma once

#include <filesystem>
#include <memory>

#include "model/motion_writer.h"

namespace ribbon {

// Layout (little-endian): "POINTCACHE2\0", i32 version 1, i32 points, f32 start 0, f32 sampling 1
// (one sample per frame), i32 samples, then per sample and point 3 x f32.
Result<std::unique_ptr<MotionWriter>> new_pc2_writer(const std::filesystem::path& path,
                                                     const Model& model, int frames);

}  // namespace ribbon
