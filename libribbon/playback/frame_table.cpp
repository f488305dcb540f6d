#include "playback/frame_table.h"

#include <algorithm>
#include <string_view>

#include "recording/checksum.h"
#include "recording/index_record.h"
#include "recording/record.h"
#include "recording/tightness_record.h"

namespace ribbon {

namespace {

constexpr std::uint64_t smallest_frame_record = record_head_bytes + frame_fields_bytes;

// A frame is readable when it and the frames since its key frame are there, in one chain.
void mark_readable(std::vector<FrameEntry>& frames) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    FrameEntry& frame = frames[i];
    const bool chained = frame.frames_since_key == 0 ||
                         (i > 0 && frames[i - 1].readable &&
                          frames[i - 1].frames_since_key + 1 == frame.frames_since_key);
    frame.readable = frame.numbers.has_value() && chained;
  }
}

// The payload of a whole record in `bytes`; nothing where head, length, checksum or type is wrong.
std::optional<std::string_view> whole_record(std::string_view bytes, RecordType type) {
  const auto head = parse_record_head(bytes);
  if (!head || head->type != type || head->payload_bytes > bytes.size() - record_head_bytes)
    return std::nullopt;
  const std::string_view payload = bytes.substr(record_head_bytes, head->payload_bytes);
  if (checksum(payload) != head->payload_checksum) return std::nullopt;
  return payload;
}

class Scan {
 public:
  Scan(const RandomAccessFile& file, std::uint32_t recording_id, std::uint64_t frames_begin)
      : file_(file),
        recording_id_(recording_id),
        frames_begin_(frames_begin),
        at_(frames_begin),
        good_end_(frames_begin) {}

  FrameTable run() {
    while (at_ < file_.size()) {
      if (!take_record() && !skip_damage()) break;
    }
    mark_readable(table_.frames);
    return std::move(table_);
  }

 private:
  // Takes the record at at_ and steps over it; false where there is none that is whole.
  bool take_record() {
    const auto head = parse_record_head(file_.read(at_, record_head_bytes));
    if (!head) return refuse("no record begins here");
    const std::uint64_t room = file_.size() - at_ - record_head_bytes;
    if (head->payload_bytes > room) return refuse("a record is not complete");
    const std::string payload = file_.read(at_ + record_head_bytes, head->payload_bytes);
    if (payload.size() != head->payload_bytes) return refuse("the disk cannot read it");
    if (checksum(payload) != head->payload_checksum) {
      if (head->type == RecordType::frame) ++lost_frames_;
      return refuse("a record fails its checksum");
    }
    const std::uint64_t end = at_ + record_head_bytes + payload.size();
    if (head->type == RecordType::frame && !take_frame(payload, end))
      return refuse("a frame does not belong here");
    if (head->type == RecordType::tightness) tightness_ = parse_tightness_payload(payload);
    take_last_words(head->type, payload);
    at_ = end;
    return true;
  }

  // Only a writer that was allowed to finish writes an index and a footer.
  void take_last_words(RecordType type, std::string_view payload) {
    if (type == RecordType::footer && parse_footer_payload(payload, recording_id_))
      table_.finished = true;
    if (type != RecordType::index) return;
    const auto index = parse_index_payload(payload, recording_id_, frames_begin_, at_);
    if (!index) return;
    table_.finished = true;
    table_.ending = index->ending;
  }

  bool refuse(const char* reason) {
    reason_ = reason;
    return false;
  }

  bool take_frame(std::string_view payload, std::uint64_t end) {
    const auto frame = parse_frame_payload(payload);
    const std::size_t next = table_.frames.size();
    if (!frame || frame->recording_id != recording_id_ || frame->frame < next) return false;
    // Frames that are missing must have had room in the bytes that were skipped.
    if (frame->frame - next > (at_ - good_end_) / smallest_frame_record) return false;
    table_.frames.resize(frame->frame);
    table_.frames.push_back(
        {at_, end - at_, frame->frames_since_key, with_tightness(*frame), false});
    good_end_ = end;
    lost_frames_ = 0;
    return true;
  }

  // A frame's tightness stands in a record of its own before it.
  [[nodiscard]] FrameNumbers with_tightness(const FrameRecord& frame) const {
    FrameNumbers numbers = frame.numbers;
    if (tightness_ && tightness_->recording_id == recording_id_ && tightness_->frame == frame.frame)
      numbers.tightness = tightness_->numbers;
    return numbers;
  }

  // Moves at_ to the next record and notes the gap; false when there is none: where the rest is
  // merely cut off, that is the end and no damage.
  bool skip_damage() {
    const std::uint64_t begin = at_;
    const std::string reason = reason_;
    const bool cut = reason == "a record is not complete" || is_start_of_head(begin);
    const auto next = next_record(begin + 1);
    if (!next && cut) return false;
    at_ = next.value_or(file_.size());
    table_.damage.push_back({begin, at_ - begin, reason});
    if (!next) table_.frames.resize(table_.frames.size() + lost_frames_);
    return true;
  }

  [[nodiscard]] bool is_start_of_head(std::uint64_t offset) const {
    const std::string rest = file_.read(offset, record_head_bytes);
    return rest.size() < record_head_bytes &&
           record_magic.starts_with(rest.substr(0, record_magic.size()));
  }

  // Where the next record with a valid head begins, from `offset` on.
  [[nodiscard]] std::optional<std::uint64_t> next_record(std::uint64_t offset) const {
    constexpr std::uint64_t window = 1 << 16;
    for (; offset + record_head_bytes <= file_.size(); offset += window) {
      const std::string bytes = file_.read(offset, window + record_head_bytes);
      for (auto found = bytes.find(record_magic); found != std::string::npos;
           found = bytes.find(record_magic, found + 1))
        if (parse_record_head(std::string_view(bytes).substr(found))) return offset + found;
    }
    return std::nullopt;
  }

  const RandomAccessFile& file_;
  std::uint32_t recording_id_;
  std::uint64_t frames_begin_;
  std::uint64_t at_;
  std::uint64_t good_end_;  // end of the last whole frame
  std::string reason_;
  std::optional<TightnessRecord> tightness_;  // the last one met
  std::size_t lost_frames_ = 0;               // damaged frame records since the last good one
  FrameTable table_;
};

}  // namespace

std::optional<FrameTable> table_from_index(const RandomAccessFile& file, std::uint32_t recording_id,
                                           std::uint64_t frames_begin) {
  constexpr std::uint64_t footer_bytes = record_head_bytes + footer_payload_bytes;
  if (file.size() < frames_begin + footer_bytes) return std::nullopt;
  const std::uint64_t footer_offset = file.size() - footer_bytes;
  const std::string footer = file.read(footer_offset, footer_bytes);
  const auto footer_payload = whole_record(footer, RecordType::footer);
  if (!footer_payload) return std::nullopt;
  const auto index_offset = parse_footer_payload(*footer_payload, recording_id);
  if (!index_offset || *index_offset < frames_begin || *index_offset > footer_offset)
    return std::nullopt;
  const std::string index = file.read(*index_offset, footer_offset - *index_offset);
  const auto index_payload = whole_record(index, RecordType::index);
  if (!index_payload) return std::nullopt;
  const auto parsed =
      parse_index_payload(*index_payload, recording_id, frames_begin, *index_offset);
  if (!parsed) return std::nullopt;
  FrameTable table;
  table.finished = true;
  table.ending = parsed->ending;
  for (const IndexEntry& entry : parsed->entries)
    table.frames.push_back(
        {entry.offset, entry.record_bytes, entry.frames_since_key, entry.numbers, false});
  mark_readable(table.frames);
  return table;
}

FrameTable table_from_scan(const RandomAccessFile& file, std::uint32_t recording_id,
                           std::uint64_t frames_begin) {
  return Scan(file, recording_id, frames_begin).run();
}

std::optional<FrameRecord> read_frame_record(const RandomAccessFile& file, const FrameEntry& entry,
                                             std::uint32_t recording_id, std::uint32_t frame,
                                             std::string& bytes) {
  bytes = file.read(entry.offset, entry.record_bytes);
  const auto payload = whole_record(bytes, RecordType::frame);
  if (!payload || payload->size() + record_head_bytes != entry.record_bytes) return std::nullopt;
  auto record = parse_frame_payload(*payload);
  if (!record || record->recording_id != recording_id || record->frame != frame ||
      record->frames_since_key != entry.frames_since_key)
    return std::nullopt;
  return record;
}

}  // namespace ribbon
