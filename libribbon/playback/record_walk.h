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
  // Begins at `offset`, where a record begins or once will.
  RecordWalk(const RandomAccessFile& file, std::uint64_t offset) : file_(file), at_(offset) {}

  // The next whole record, whatever it says, or the next damage. The end is where the file ends, or
  // a record that is merely cut off.
  WalkStep next();

 private:
  WalkStep damage(WalkStep step, const char* reason, bool may_be_cut);
  [[nodiscard]] bool is_start_of_head(std::uint64_t offset) const;
  [[nodiscard]] std::optional<std::uint64_t> next_head(std::uint64_t offset) const;

  const RandomAccessFile& file_;
  std::uint64_t at_;
  std::string payload_;
};

// The payload of a whole record in `bytes`, which it fills; nothing where head, length, checksum or
// type is wrong.
std::optional<std::string_view> whole_record(std::string_view bytes, RecordType type);

}  // namespace ribbon
