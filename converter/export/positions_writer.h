// The part that simple formats share: a header, then the ribbon's positions frame after frame.
#pragma once

#include <bit>
#include <filesystem>
#include <memory>
#include <string_view>

#include "model/motion_writer.h"

namespace ribbon {

// Writes `header` and then, for each of `frames` frames and each point of the ribbon, 3 x f32 in
// the byte order `order`.
Result<std::unique_ptr<MotionWriter>> new_positions_writer(const std::filesystem::path& path,
                                                           std::string_view header,
                                                           const Model& model, int frames,
                                                           std::endian order);

}  // namespace ribbon
