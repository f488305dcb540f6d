// Which frames a frame is predicted from.
#pragma once

#include <cstdint>
#include <vector>

namespace ribbon {

inline constexpr std::size_t most_references = 4;

// Longer groups are smaller and slower to seek in.
inline constexpr std::uint32_t live_group_frames = 16;

// While a simulation runs: the frames before `frame` in its group of live_group_frames, up to
// three, the nearest first. None for the first of a group.
std::vector<std::uint32_t> live_references(std::uint32_t frame);

}  // namespace ribbon
