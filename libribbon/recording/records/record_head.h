// Records: what a recording file is made of (FORMAT.md, sections 1 and 2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/ribbon_grid.h"

namespace ribbon {

inline constexpr std::string_view file_signature{"\x89RBN\r\n\x1A\n", 8};
inline constexpr std::string_view record_magic{"\xB1REC", 4};
inline constexpr std::size_t record_head_bytes = 24;

enum class RecordType : std::uint32_t {
  header = 1,
  frame = 2,
  index = 3,
  footer = 4,
  checkpoint = 5,
  session = 6,
  directory = 7
};

struct RecordHead {
  RecordType type{};  // may be one that this version does not know
  std::uint64_t payload_bytes = 0;
  std::uint32_t payload_checksum = 0;
};

inline constexpr std::uint64_t most_header_bytes = std::uint64_t{1} << 31;

// Of the payload of a record other than the header, of a ribbon like this.
std::uint64_t most_payload_bytes(RecordType type, const RibbonGrid& grid);

// May a record of so many bytes lie at `offset`, wholly before `limit`?
inline bool lies_before(std::uint64_t limit, std::uint64_t offset, std::uint64_t record_bytes) {
  return offset <= limit && record_bytes >= record_head_bytes && record_bytes <= limit - offset;
}

// A whole record: head and payload.
std::string make_record(RecordType type, std::string_view payload);

// The head that `bytes` begin with; nothing where they are too few, have no magic or fail the
// head's checksum. The payload is not looked at.
std::optional<RecordHead> parse_record_head(std::string_view bytes);

}  // namespace ribbon
