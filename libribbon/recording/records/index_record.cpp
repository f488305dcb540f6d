#include "recording/records/index_record.h"

#include "recording/coding/block.h"
#include "recording/coding/bytes.h"

namespace ribbon {

namespace {

constexpr std::size_t frame_row_bytes = 51 + sizeof(float) * tightness_columns.size();
constexpr std::size_t other_row_bytes = 24;

void put_references(std::string& bytes, const std::vector<IndexedFrame>& frames) {
  for (const IndexedFrame& frame : frames)
    put<std::uint8_t>(bytes, static_cast<std::uint8_t>(frame.references.size()));
  for (std::size_t k = 0; k < most_references; ++k)
    for (const IndexedFrame& frame : frames)
      put<std::uint32_t>(bytes, k < frame.references.size() ? frame.frame - frame.references[k]
                                                            : std::uint32_t{0});
}

// False where a frame has too many.
bool take_references(ByteTaker& taker, std::vector<IndexedFrame>& frames) {
  std::vector<std::uint8_t> counts(frames.size());
  for (std::uint8_t& count : counts) count = taker.take<std::uint8_t>();
  for (const std::uint8_t count : counts)
    if (count > most_references) return false;
  for (std::size_t k = 0; k < most_references; ++k)
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const auto back = taker.take<std::uint32_t>();
      if (k < counts[i]) frames[i].references.push_back(frames[i].frame - back);
    }
  return true;
}

void put_tightness(std::string& bytes, const std::vector<IndexedFrame>& frames) {
  for (const IndexedFrame& frame : frames)
    put<std::uint8_t>(bytes, frame.numbers.tightness ? 1 : 0);
  for (const TightnessColumn& column : tightness_columns)
    for (const IndexedFrame& frame : frames)
      put<float>(bytes, frame.numbers.tightness.value_or(TightnessNumbers{}).*column.value);
}

void take_tightness(ByteTaker& taker, std::vector<IndexedFrame>& frames) {
  for (IndexedFrame& frame : frames)
    if (taker.take<std::uint8_t>() != 0) frame.numbers.tightness.emplace();
  for (const TightnessColumn& column : tightness_columns)
    for (IndexedFrame& frame : frames) {
      const auto value = taker.take<float>();
      if (frame.numbers.tightness) (*frame.numbers.tightness).*column.value = value;
    }
}

std::string frame_table(const std::vector<IndexedFrame>& frames) {
  std::string bytes;
  bytes.reserve(frames.size() * frame_row_bytes);
  for (const IndexedFrame& frame : frames) put<double>(bytes, frame.numbers.time_s);
  for (const IndexedFrame& frame : frames) put<double>(bytes, frame.numbers.worst_strain);
  for (const IndexedFrame& frame : frames)
    put<std::uint32_t>(bytes, frame.numbers.penetrating_edges);
  for (const IndexedFrame& frame : frames)
    put<std::uint32_t>(bytes, frame.numbers.recovery_iterations);
  std::uint32_t next = 0;
  for (const IndexedFrame& frame : frames) {
    put<std::uint32_t>(bytes, frame.frame - next);
    next = frame.frame + 1;
  }
  std::uint64_t end = 0;
  for (const IndexedFrame& frame : frames) {
    put<std::uint64_t>(bytes, frame.offset - end);
    end = frame.offset + frame.record_bytes;
  }
  for (const IndexedFrame& frame : frames) put<std::uint32_t>(bytes, frame.record_bytes);
  put_references(bytes, frames);
  put_tightness(bytes, frames);
  for (const IndexedFrame& frame : frames) put<std::uint8_t>(bytes, frame.numbers.stage);
  return bytes;
}

// From gaps to offsets; false where a frame does not lie before `limit`.
bool set_offsets(std::vector<IndexedFrame>& frames, std::uint64_t limit) {
  std::uint64_t end = 0;
  for (IndexedFrame& frame : frames) {
    if (frame.offset > limit - end) return false;
    frame.offset += end;
    if (frame.record_bytes < smallest_frame_record || frame.record_bytes > limit - frame.offset ||
        frame.frame >= most_frames(limit))
      return false;
    end = frame.offset + frame.record_bytes;
  }
  return true;
}

// The inverse of frame_table(); `frames` has as many rows as its size tells.
bool parse_frame_table(std::string_view bytes, std::uint64_t limit,
                       std::vector<IndexedFrame>& frames) {
  ByteTaker taker(bytes);
  for (IndexedFrame& frame : frames) frame.numbers.time_s = taker.take<double>();
  for (IndexedFrame& frame : frames) frame.numbers.worst_strain = taker.take<double>();
  for (IndexedFrame& frame : frames) frame.numbers.penetrating_edges = taker.take<std::uint32_t>();
  for (IndexedFrame& frame : frames)
    frame.numbers.recovery_iterations = taker.take<std::uint32_t>();
  std::uint32_t next = 0;
  for (IndexedFrame& frame : frames) {
    frame.frame = next + taker.take<std::uint32_t>();
    next = frame.frame + 1;
  }
  for (IndexedFrame& frame : frames) frame.offset = taker.take<std::uint64_t>();
  for (IndexedFrame& frame : frames) frame.record_bytes = taker.take<std::uint32_t>();
  if (!set_offsets(frames, limit) || !take_references(taker, frames)) return false;
  take_tightness(taker, frames);
  for (IndexedFrame& frame : frames) frame.numbers.stage = taker.take<std::uint8_t>();
  return taker.complete();
}

std::string table_of_others(const std::vector<IndexedOther>& others) {
  std::string bytes;
  bytes.reserve(others.size() * other_row_bytes);
  for (const IndexedOther& other : others)
    put<std::uint32_t>(bytes, static_cast<std::uint32_t>(other.type));
  for (const IndexedOther& other : others) put<std::uint32_t>(bytes, other.frame);
  for (const IndexedOther& other : others) put<std::uint64_t>(bytes, other.offset);
  for (const IndexedOther& other : others) put<std::uint64_t>(bytes, other.record_bytes);
  return bytes;
}

bool parse_table_of_others(std::string_view bytes, std::uint64_t limit,
                           std::vector<IndexedOther>& others) {
  ByteTaker taker(bytes);
  for (IndexedOther& other : others)
    other.type = static_cast<RecordType>(taker.take<std::uint32_t>());
  for (IndexedOther& other : others) other.frame = taker.take<std::uint32_t>();
  for (IndexedOther& other : others) other.offset = taker.take<std::uint64_t>();
  for (IndexedOther& other : others) {
    other.record_bytes = taker.take<std::uint64_t>();
    if (other.offset > limit || other.record_bytes < record_head_bytes ||
        other.record_bytes > limit - other.offset)
      return false;
  }
  return taker.complete();
}

}  // namespace

std::string index_payload(std::uint32_t recording_id, const Index& index) {
  std::string bytes;
  put<std::uint32_t>(bytes, recording_id);
  put<std::uint64_t>(bytes, index.previous);
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(index.frames.size()));
  put_block(bytes, frame_table(index.frames));
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(index.others.size()));
  put_block(bytes, table_of_others(index.others));
  return bytes;
}

std::optional<Index> parse_index_payload(std::string_view payload, std::uint32_t recording_id,
                                         std::uint64_t offset) {
  ByteTaker taker(payload);
  Index index;
  const auto id = taker.take<std::uint32_t>();
  index.previous = taker.take<std::uint64_t>();
  const auto frames = taker.take<std::uint32_t>();
  if (!taker.complete() || id != recording_id || frames > offset / smallest_frame_record)
    return std::nullopt;
  const auto frame_content = take_table(taker, frames, frame_row_bytes);
  const auto others = taker.take<std::uint32_t>();
  if (!frame_content || others > offset / record_head_bytes) return std::nullopt;
  const auto other_content = take_table(taker, others, other_row_bytes);
  if (!other_content) return std::nullopt;
  index.frames.resize(frames);
  index.others.resize(others);
  if (!parse_frame_table(*frame_content, offset, index.frames) ||
      !parse_table_of_others(*other_content, offset, index.others))
    return std::nullopt;
  return index;
}

}  // namespace ribbon
