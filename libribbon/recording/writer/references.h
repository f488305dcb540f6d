// Which frames a frame is predicted from while a simulation runs.
#pragma once

#include <cstdint>

#include "recording/records/reference_list.h"

namespace ribbon {

// Longer groups are smaller and slower to seek in.
inline constexpr std::uint32_t group_frames = 20;

// The two frames before `frame`, the nearest first, as far as they belong to its group of
// group_frames. None for the first of a group.
ReferenceList references_of(std::uint32_t frame);

}  // namespace ribbon
