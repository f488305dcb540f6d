// NPY: the positions of the ribbon in every frame as an array for NumPy.
#pragma once

#include <filesystem>
#include <memory>

#include "model/motion_writer.h"

namespace ribbon {

// Layout: version 1.0; "<f4" in C order, frames x along x across x 3. The numbers begin at a
// multiple of 64 bytes, so that they can be mapped into memory. Fails where the ribbon's vertices
// are no grid.
Result<std::unique_ptr<MotionWriter>> new_npy_writer(const std::filesystem::path& path,
                                                     const Model& model, int frames);

}  // namespace ribbon
