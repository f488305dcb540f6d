#include "recording/records/directory_record.h"

#include <algorithm>

#include "recording/coding/bytes.h"
#include "recording/coding/table.h"

namespace ribbon {

namespace {

constexpr std::tuple index_columns{&IndexLocation::offset,       &IndexLocation::record_bytes,
                                   &IndexLocation::lowest_frame, &IndexLocation::highest_frame,
                                   &IndexLocation::frames,       &IndexLocation::others};

}  // namespace

IndexLocation location_of(const Index& index, std::uint64_t offset, std::uint32_t record_bytes) {
  IndexLocation location{.offset = offset,
                         .record_bytes = record_bytes,
                         .frames = static_cast<std::uint32_t>(index.frames.size()),
                         .others = static_cast<std::uint32_t>(index.others.size())};
  if (index.frames.empty()) return location;
  const auto [lowest, highest] = std::minmax_element(
      index.frames.begin(), index.frames.end(),
      [](const IndexedFrame& a, const IndexedFrame& b) { return a.frame < b.frame; });
  location.lowest_frame = lowest->frame;
  location.highest_frame = highest->frame;
  return location;
}

std::string directory_payload(std::uint32_t recording_id, const Directory& directory) {
  std::string bytes;
  put<std::uint32_t>(bytes, recording_id);
  put<std::uint32_t>(bytes, directory.frames);
  put<std::uint8_t>(bytes, static_cast<std::uint8_t>(directory.ending));
  for (int i = 0; i < 3; ++i) put<std::uint8_t>(bytes, 0);
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(directory.indices.size()));
  put_table(bytes, directory.indices, index_columns);
  return bytes;
}

std::optional<Directory> parse_directory_payload(std::string_view payload,
                                                 std::uint32_t recording_id, std::uint64_t offset,
                                                 std::uint64_t written_bytes) {
  ByteTaker taker(payload);
  Directory directory;
  const auto id = taker.take<std::uint32_t>();
  directory.frames = taker.take<std::uint32_t>();
  const auto ending = taker.take<std::uint8_t>();
  // Endings that this version does not know are as good as none.
  if (ending <= static_cast<std::uint8_t>(RunEnding::limit))
    directory.ending = static_cast<RunEnding>(ending);
  taker.take_bytes(3);
  const auto count = taker.take<std::uint32_t>();
  if (!taker.complete() || id != recording_id || directory.frames > most_frames(written_bytes) ||
      count > written_bytes / record_head_bytes ||
      !take_table(taker, count, directory.indices, index_columns))
    return std::nullopt;
  for (const IndexLocation& index : directory.indices)
    if (!lies_before(offset, index.offset, index.record_bytes) ||
        index.lowest_frame > index.highest_frame ||
        (index.frames > 0 && index.highest_frame >= directory.frames))
      return std::nullopt;
  return directory;
}

std::string footer_payload(std::uint32_t recording_id, std::uint64_t directory_offset) {
  std::string bytes;
  put<std::uint64_t>(bytes, directory_offset);
  put<std::uint32_t>(bytes, recording_id);
  put<std::uint32_t>(bytes, 0);
  return bytes;
}

std::optional<std::uint64_t> parse_footer_payload(std::string_view payload,
                                                  std::uint32_t recording_id) {
  ByteTaker taker(payload);
  const auto offset = taker.take<std::uint64_t>();
  const auto id = taker.take<std::uint32_t>();
  taker.take<std::uint32_t>();  // zero
  if (!taker.complete() || id != recording_id) return std::nullopt;
  return offset;
}

}  // namespace ribbon
