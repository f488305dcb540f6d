#include "recording/records/directory_record.h"

#include <algorithm>

#include "recording/coding/block.h"
#include "recording/coding/bytes.h"

namespace ribbon {

namespace {

constexpr std::size_t row_bytes = 28;

std::string table(const std::vector<IndexLocation>& indices) {
  std::string bytes;
  bytes.reserve(indices.size() * row_bytes);
  for (const IndexLocation& index : indices) put<std::uint64_t>(bytes, index.offset);
  for (const IndexLocation& index : indices) put<std::uint32_t>(bytes, index.record_bytes);
  for (const IndexLocation& index : indices) put<std::uint32_t>(bytes, index.lowest_frame);
  for (const IndexLocation& index : indices) put<std::uint32_t>(bytes, index.highest_frame);
  for (const IndexLocation& index : indices) put<std::uint32_t>(bytes, index.frames);
  for (const IndexLocation& index : indices) put<std::uint32_t>(bytes, index.others);
  return bytes;
}

void parse_table(std::string_view bytes, std::vector<IndexLocation>& indices) {
  ByteTaker taker(bytes);
  for (IndexLocation& index : indices) index.offset = taker.take<std::uint64_t>();
  for (IndexLocation& index : indices) index.record_bytes = taker.take<std::uint32_t>();
  for (IndexLocation& index : indices) index.lowest_frame = taker.take<std::uint32_t>();
  for (IndexLocation& index : indices) index.highest_frame = taker.take<std::uint32_t>();
  for (IndexLocation& index : indices) index.frames = taker.take<std::uint32_t>();
  for (IndexLocation& index : indices) index.others = taker.take<std::uint32_t>();
}

bool lies_before(const IndexLocation& index, std::uint64_t offset) {
  return index.offset <= offset && index.record_bytes >= record_head_bytes &&
         index.record_bytes <= offset - index.offset && index.lowest_frame <= index.highest_frame;
}

bool has_frames_within(const IndexLocation& index, std::uint32_t frames) {
  return index.frames == 0 || index.highest_frame < frames;
}

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
  put_block(bytes, table(directory.indices));
  return bytes;
}

std::optional<Directory> parse_directory_payload(std::string_view payload,
                                                 std::uint32_t recording_id, std::uint64_t offset) {
  ByteTaker taker(payload);
  Directory directory;
  const auto id = taker.take<std::uint32_t>();
  directory.frames = taker.take<std::uint32_t>();
  const auto ending = taker.take<std::uint8_t>();
  // Endings that this version does not know are as good as none.
  if (ending <= static_cast<std::uint8_t>(RunEnding::second_end_slips))
    directory.ending = static_cast<RunEnding>(ending);
  taker.take_bytes(3);
  const auto count = taker.take<std::uint32_t>();
  if (!taker.complete() || id != recording_id || directory.frames > most_frames(offset) ||
      count > offset / record_head_bytes)
    return std::nullopt;
  const auto content = take_table(taker, count, row_bytes);
  if (!content) return std::nullopt;
  directory.indices.resize(count);
  parse_table(*content, directory.indices);
  const bool valid = std::all_of(
      directory.indices.begin(), directory.indices.end(), [&](const IndexLocation& index) {
        return lies_before(index, offset) && has_frames_within(index, directory.frames);
      });
  return valid ? std::optional(std::move(directory)) : std::nullopt;
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
