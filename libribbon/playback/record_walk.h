// From record to record through a file, over damage as well (FORMAT.md, section 2).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "playback/random_access_file.h"
#include "recording/records/record_head.h"

namespace ribbon {

struct WalkStep {
  enum class Kind { record, damage, end };
  Kind kind = Kind::end;
  std::uint64_t offset = 0;  // where the record or the damage begins,
  std::uint64_t length = 0;  // and how many bytes it has
  RecordType type{};         // of a record, or of a damaged one whose head is whole
  bool head_is_whole = false;
  std::string_view payload = {};  // of a record; valid until the next step
  const char* reason = "";        // of damage
};

class RecordWalk {
 public:
  // Begins at `offset`, where a record begins or once will. grid: that of the header.
  RecordWalk(const RandomAccessFile& file, const RibbonGrid& grid, std::uint64_t offset)
      : file_(file), grid_(grid), at_(offset) {}

  // The next whole record, whatever it says, or the next damage. The end is where the file ends, or
  // a record that is merely cut off.
  WalkStep next();

 private:
  WalkStep damage(WalkStep step, const char* reason, bool may_be_cut);
  [[nodiscard]] std::optional<std::uint64_t> next_head(std::uint64_t offset) const;

  const RandomAccessFile& file_;
  RibbonGrid grid_;
  std::uint64_t at_;
  std::string payload_;
};

// Where a file is said to hold a record.
struct RecordPlace {
  RecordType type{};
  std::uint64_t offset = 0;
  std::uint64_t bytes = 0;  // head and payload
};

// The payload of the record; nothing where it is not there, whole and as long as is said. grid:
// that of the header. Its head is read first, for all that is said may be wrong.
std::optional<std::string> read_payload(const RandomAccessFile& file, const RibbonGrid& grid,
                                        const RecordPlace& place);

}  // namespace ribbon
