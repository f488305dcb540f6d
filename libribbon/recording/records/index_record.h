// The payload of an index record: where some frames lie, and what they tell (FORMAT.md, section 6).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/records/frame_record.h"
#include "recording/records/record_head.h"

namespace ribbon {

// A writer gathers so many frames in one index record.
inline constexpr std::size_t frames_in_index = 256;

inline constexpr std::uint64_t smallest_frame_record = record_head_bytes + frame_fields_bytes;

// No frame number n may have fewer than n - frames_ahead frames before it in the file.
inline constexpr std::uint64_t frames_ahead = 1024;

inline constexpr std::uint64_t most_frames_of_all = std::uint64_t{1} << 30;

// How many frames a file may have, at most, whose records have so many bytes together.
inline std::uint64_t most_frames(std::uint64_t bytes) {
  return std::min(bytes / smallest_frame_record + frames_ahead, most_frames_of_all);
}

struct IndexedFrame {
  std::uint32_t frame = 0;                                // from 0
  std::uint32_t record_bytes = 0;                         // head and payload
  std::uint64_t offset = 0;                               // of the record in the file
  std::optional<std::uint32_t> reference = std::nullopt;  // number of a frame
  FrameNumbers numbers = {};

  bool operator==(const IndexedFrame&) const = default;
};

// A checkpoint, a session, or what later versions know.
struct IndexedOther {
  RecordType type{};
  std::uint32_t frame = 0;  // a session's first frame
  std::uint64_t offset = 0;
  std::uint64_t record_bytes = 0;

  bool operator==(const IndexedOther&) const = default;
};

struct Index {
  std::uint64_t previous = 0;        // offset of the index record before this one; 0: none
  std::vector<IndexedFrame> frames;  // as they lie in the file
  std::vector<IndexedOther> others;

  bool operator==(const Index&) const = default;
};

std::string index_payload(std::uint32_t recording_id, const Index& index);

// Nothing where the payload is malformed, of another recording, names records that do not lie
// before `offset`, where the index record itself begins, or more than `written_bytes` can hold: so
// many are there, at most, of those before it.
std::optional<Index> parse_index_payload(std::string_view payload, std::uint32_t recording_id,
                                         std::uint64_t offset, std::uint64_t written_bytes);

}  // namespace ribbon
