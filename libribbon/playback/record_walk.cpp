#include "playback/record_walk.h"

#include <algorithm>

#include "recording/coding/checksum.h"

namespace ribbon {

namespace {

constexpr const char* unreadable = "the disk cannot read it";

bool is_start_of_head(std::string_view bytes) {
  return bytes.size() < record_head_bytes &&
         record_magic.starts_with(bytes.substr(0, record_magic.size()));
}

}  // namespace

WalkStep RecordWalk::next() {
  WalkStep step{.offset = at_};
  if (at_ >= file_.size()) return step;
  const std::string first_bytes = file_.read(at_, record_head_bytes);
  if (first_bytes.size() < std::min<std::uint64_t>(record_head_bytes, file_.size() - at_))
    return damage(step, unreadable, false);
  const auto head = parse_record_head(first_bytes);
  if (!head) return damage(step, "no record begins here", is_start_of_head(first_bytes));
  step.type = head->type;
  step.head_is_whole = true;
  if (head->payload_bytes > file_.size() - at_ - record_head_bytes)
    return damage(step, "a record is not complete", true);
  if (head->payload_bytes > most_payload_bytes(head->type, grid_))
    return damage(step, "a record claims to be larger than any", false);
  payload_ = file_.read(at_ + record_head_bytes, head->payload_bytes);
  if (payload_.size() != head->payload_bytes) return damage(step, unreadable, false);
  if (checksum(payload_) != head->payload_checksum)
    return damage(step, "a record fails its checksum", false);
  step.kind = WalkStep::Kind::record;
  step.length = record_head_bytes + payload_.size();
  step.payload = payload_;
  at_ += step.length;
  return step;
}

// Up to the next record; where there is none, the rest may merely be cut off, which is no damage.
WalkStep RecordWalk::damage(WalkStep step, const char* reason, bool may_be_cut) {
  const auto next = next_head(at_ + 1);
  if (!next && may_be_cut) return {.offset = at_};
  step.kind = WalkStep::Kind::damage;
  step.reason = reason;
  step.length = next.value_or(file_.size()) - at_;
  at_ += step.length;
  return step;
}

// Where the next record with a valid head begins, from `offset` on.
std::optional<std::uint64_t> RecordWalk::next_head(std::uint64_t offset) const {
  constexpr std::uint64_t window = 1 << 16;
  while (true) {
    offset = file_.next_written(offset);  // no magic begins with a zero
    if (offset + record_head_bytes > file_.size()) return std::nullopt;
    const std::string bytes = file_.read(offset, window + record_head_bytes);
    for (auto found = bytes.find(record_magic); found != std::string::npos;
         found = bytes.find(record_magic, found + 1))
      if (parse_record_head(std::string_view(bytes).substr(found))) return offset + found;
    offset += window;
  }
}

std::optional<std::string> read_payload(const RandomAccessFile& file, const RibbonGrid& grid,
                                        const RecordPlace& place) {
  const auto head = parse_record_head(file.read(place.offset, record_head_bytes));
  if (!head || head->type != place.type || head->payload_bytes + record_head_bytes != place.bytes ||
      head->payload_bytes > most_payload_bytes(place.type, grid))
    return std::nullopt;
  std::string payload = file.read(place.offset + record_head_bytes, head->payload_bytes);
  if (payload.size() != head->payload_bytes || checksum(payload) != head->payload_checksum)
    return std::nullopt;
  return payload;
}

}  // namespace ribbon
