// The payloads of directory and footer: where the index records lie (FORMAT.md, section 7).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/records/index_record.h"

namespace ribbon {

// An index record, and what it tells about.
struct IndexLocation {
  std::uint64_t offset = 0;
  std::uint32_t record_bytes = 0;
  std::uint32_t lowest_frame = 0;
  std::uint32_t highest_frame = 0;
  std::uint32_t frames = 0;
  std::uint32_t others = 0;

  bool operator==(const IndexLocation&) const = default;
};

IndexLocation location_of(const Index& index, std::uint64_t offset, std::uint32_t record_bytes);

struct Directory {
  std::uint32_t frames = 0;  // one more than the highest frame number
  RunEnding ending = RunEnding::unknown;
  std::vector<IndexLocation> indices;

  bool operator==(const Directory&) const = default;
};

std::string directory_payload(std::uint32_t recording_id, const Directory& directory);

// Nothing where the payload is malformed, of another recording, names index records that do not lie
// before `offset`, where the directory record itself begins, counts fewer frames than these, or
// more of anything than `written_bytes` can hold: so many are there, at most, of those before it.
std::optional<Directory> parse_directory_payload(std::string_view payload,
                                                 std::uint32_t recording_id, std::uint64_t offset,
                                                 std::uint64_t written_bytes);

inline constexpr std::size_t footer_payload_bytes = 16;

std::string footer_payload(std::uint32_t recording_id, std::uint64_t directory_offset);

// The directory's offset; nothing where the footer is of another recording.
std::optional<std::uint64_t> parse_footer_payload(std::string_view payload,
                                                  std::uint32_t recording_id);

}  // namespace ribbon
