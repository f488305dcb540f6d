// Which frames a frame is predicted from.
#pragma once

#include <cstdint>
#include <vector>

#include "recording/records/reference_list.h"

namespace ribbon {

// Longer groups are smaller and slower to seek in.
inline constexpr std::uint32_t live_group_frames = 16;
inline constexpr std::uint32_t compact_group_frames = 32;

// While a simulation runs: the frames before `frame` in its group of live_group_frames, up to
// three, the nearest first. None for the first of a group.
ReferenceList live_references(std::uint32_t frame);

struct PlannedFrame {
  std::uint32_t frame = 0;        // from 0
  ReferenceList references = {};  // none, or as Prediction::b wants them
};

// How a recording of `frames` frames is compacted: its frames in the order in which they are coded.
// Key frames are every compact_group_frames-th and the last one. Between two of them comes the
// frame in the middle, then those in the middle of the halves and so on, each predicted from the
// nearest frames that the group has by then: the one before, the one after, then the next ones
// outwards. So no frame needs any outside of its group, and those halve their distance with each
// turn.
std::vector<PlannedFrame> compaction_plan(std::uint32_t frames);

}  // namespace ribbon
