// The index and the footer: where each frame lies (FORMAT.md, sections 6 and 7).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/recording.h"

namespace ribbon {

struct IndexEntry {
  std::uint64_t offset = 0;        // of the frame record in the file
  std::uint32_t record_bytes = 0;  // head and payload
  std::uint32_t frames_since_key = 0;
  FrameNumbers numbers;
};

struct Index {
  std::vector<IndexEntry> entries;
  RunEnding ending = RunEnding::unknown;
};

// Either all frames have a tightness or none. Frames lie in `entries` in their order; the first of
// them begins at or after `frames_begin`, the end of the header record.
std::string index_payload(std::uint32_t recording_id, const Index& index,
                          std::uint64_t frames_begin);

// Nothing where the payload is malformed, of another recording, or names frames that do not lie
// between `frames_begin` and `frames_end`.
std::optional<Index> parse_index_payload(std::string_view payload, std::uint32_t recording_id,
                                         std::uint64_t frames_begin, std::uint64_t frames_end);

inline constexpr std::size_t footer_payload_bytes = 16;

std::string footer_payload(std::uint32_t recording_id, std::uint64_t index_offset);

// The index's offset; nothing where the footer is of another recording.
std::optional<std::uint64_t> parse_footer_payload(std::string_view payload,
                                                  std::uint32_t recording_id);

}  // namespace ribbon
