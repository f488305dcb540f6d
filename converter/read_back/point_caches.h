// Files of positions alone: .npy, .mdd and .pc2.
#pragma once

#include <filesystem>
#include <memory>

#include "converter/read_back/written_motion.h"

namespace ribbon {

// NumPy's format 1.0, "<f4" in C order, frames x along x across x 3. All three throw Spoiled where
// the file's length is not what its head says.
std::unique_ptr<WrittenMotion> read_npy(const std::filesystem::path& path);
// LightWave's motion designer data, big-endian, with a time for each frame.
std::unique_ptr<WrittenMotion> read_mdd(const std::filesystem::path& path);
// 3ds Max's point cache 2, one sample a frame from frame 0 on.
std::unique_ptr<WrittenMotion> read_pc2(const std::filesystem::path& path);

}  // namespace ribbon
