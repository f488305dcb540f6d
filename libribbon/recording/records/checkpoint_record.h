// The payload of a checkpoint record (FORMAT.md, section 5.2).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/ribbon_grid.h"
#include "recording/records/recording.h"

namespace ribbon {

// The largest state that a checkpoint of such a ribbon may hold, in bytes.
std::uint64_t largest_state_bytes(const RibbonGrid& grid);

// The state has at most largest_state_bytes().
std::string checkpoint_payload(std::uint32_t recording_id, std::uint32_t frame, std::uint64_t steps,
                               std::string_view state);

// What stands before the state, which is not looked at.
struct CheckpointFields {
  std::uint32_t recording_id = 0;
  std::uint32_t frame = 0;  // from 0
  std::uint64_t steps = 0;  // simulation steps done
  std::uint64_t state_bytes = 0;
  std::uint32_t state_checksum = 0;
  std::uint32_t state_at = 0;  // where in the payload the compressed state begins
};
std::optional<CheckpointFields> parse_checkpoint_fields(std::string_view payload);

// Nothing where the payload is too short or of another recording, or the state is not what it was.
std::optional<Checkpoint> parse_checkpoint_payload(std::string_view payload,
                                                   std::uint32_t recording_id,
                                                   const RibbonGrid& grid);

}  // namespace ribbon
