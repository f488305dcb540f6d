#include "recording/records/index_record.h"

#include "recording/coding/bytes.h"
#include "recording/coding/table.h"

namespace ribbon {

namespace {

// A frame as the table has it.
struct FrameRow : TightnessNumbers {
  double time_s = 0;
  double worst_strain = 0;
  std::uint32_t penetrating_edges = 0;
  std::uint32_t recovery_iterations = 0;
  std::uint32_t step = 0;  // from the number after that of the frame before
  std::uint64_t gap = 0;   // from the end of the record before
  std::uint32_t record_bytes = 0;
  std::uint32_t back = 0;  // to the reference; 0: there is none
  std::uint8_t has_tightness = 0;
  std::uint8_t stage = 0;
};

constexpr std::tuple frame_columns{&FrameRow::time_s,
                                   &FrameRow::worst_strain,
                                   &FrameRow::penetrating_edges,
                                   &FrameRow::recovery_iterations,
                                   &FrameRow::step,
                                   &FrameRow::gap,
                                   &FrameRow::record_bytes,
                                   &FrameRow::back,
                                   &FrameRow::has_tightness,
                                   &FrameRow::progress,
                                   &FrameRow::truncated,
                                   &FrameRow::pull,
                                   &FrameRow::contact,
                                   &FrameRow::rope_length,
                                   &FrameRow::stage};
constexpr std::tuple other_columns{&IndexedOther::type, &IndexedOther::frame, &IndexedOther::offset,
                                   &IndexedOther::record_bytes};

std::vector<FrameRow> rows_of(const std::vector<IndexedFrame>& frames) {
  std::vector<FrameRow> rows;
  std::uint32_t next = 0;
  std::uint64_t end = 0;
  for (const IndexedFrame& frame : frames) {
    const FrameNumbers& numbers = frame.numbers;
    rows.push_back({numbers.tightness.value_or(TightnessNumbers{}), numbers.time_s,
                    numbers.worst_strain, numbers.penetrating_edges, numbers.recovery_iterations,
                    frame.frame - next, frame.offset - end, frame.record_bytes,
                    frame.reference ? frame.frame - *frame.reference : 0,
                    static_cast<std::uint8_t>(numbers.tightness ? 1 : 0), numbers.stage});
    next = frame.frame + 1;
    end = frame.offset + frame.record_bytes;
  }
  return rows;
}

// Nothing where a frame does not lie before `limit` or there cannot be so many.
std::optional<std::vector<IndexedFrame>> frames_of(const std::vector<FrameRow>& rows,
                                                   std::uint64_t limit, std::uint64_t most) {
  std::vector<IndexedFrame> frames;
  std::uint32_t next = 0;
  std::uint64_t end = 0;
  for (const FrameRow& row : rows) {
    if (row.gap > limit - end) return std::nullopt;
    IndexedFrame frame{next + row.step, row.record_bytes, end + row.gap};
    if (row.record_bytes < smallest_frame_record || row.record_bytes > limit - frame.offset ||
        frame.frame >= most)
      return std::nullopt;
    if (row.back != 0) frame.reference = frame.frame - row.back;
    frame.numbers = {row.time_s, row.worst_strain, row.penetrating_edges, row.recovery_iterations};
    if (row.has_tightness != 0) frame.numbers.tightness = row;
    frame.numbers.stage = row.stage;
    next = frame.frame + 1;
    end = frame.offset + frame.record_bytes;
    frames.push_back(frame);
  }
  return frames;
}

}  // namespace

std::string index_payload(std::uint32_t recording_id, const Index& index) {
  std::string bytes;
  put<std::uint32_t>(bytes, recording_id);
  put<std::uint64_t>(bytes, index.previous);
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(index.frames.size()));
  put_table(bytes, rows_of(index.frames), frame_columns);
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(index.others.size()));
  put_table(bytes, index.others, other_columns);
  return bytes;
}

std::optional<Index> parse_index_payload(std::string_view payload, std::uint32_t recording_id,
                                         std::uint64_t offset, std::uint64_t written_bytes) {
  ByteTaker taker(payload);
  Index index;
  const auto id = taker.take<std::uint32_t>();
  index.previous = taker.take<std::uint64_t>();
  const auto frame_count = taker.take<std::uint32_t>();
  std::vector<FrameRow> rows;
  if (!taker.complete() || id != recording_id ||
      frame_count > written_bytes / smallest_frame_record ||
      !take_table(taker, frame_count, rows, frame_columns))
    return std::nullopt;
  const auto other_count = taker.take<std::uint32_t>();
  if (other_count > written_bytes / record_head_bytes ||
      !take_table(taker, other_count, index.others, other_columns))
    return std::nullopt;
  const std::uint64_t most = most_frames(written_bytes);
  for (const IndexedOther& other : index.others)
    if (!lies_before(offset, other.offset, other.record_bytes) || other.frame > most)
      return std::nullopt;
  auto frames = frames_of(rows, offset, most);
  if (!frames) return std::nullopt;
  index.frames = *std::move(frames);
  return index;
}

}  // namespace ribbon
