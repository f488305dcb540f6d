#include "recording/index_record.h"

#include <array>

#include "recording/bytes.h"
#include "recording/compression.h"
#include "recording/frame_record.h"
#include "recording/record.h"

namespace ribbon {

namespace {

constexpr std::uint64_t smallest_frame_record = record_head_bytes + frame_fields_bytes;
constexpr std::size_t table_row_bytes = 36;

std::string table(const std::vector<IndexEntry>& entries, std::uint64_t frames_begin) {
  std::string bytes;
  bytes.reserve(entries.size() * table_row_bytes);
  for (const IndexEntry& entry : entries) put<double>(bytes, entry.numbers.time_s);
  for (const IndexEntry& entry : entries) put<double>(bytes, entry.numbers.worst_strain);
  for (const IndexEntry& entry : entries)
    put<std::uint32_t>(bytes, entry.numbers.penetrating_edges);
  for (const IndexEntry& entry : entries)
    put<std::uint32_t>(bytes, entry.numbers.recovery_iterations);
  for (const IndexEntry& entry : entries) put<std::uint32_t>(bytes, entry.frames_since_key);
  for (const IndexEntry& entry : entries) put<std::uint32_t>(bytes, entry.record_bytes);
  std::uint64_t end = frames_begin;
  for (const IndexEntry& entry : entries) {
    put<std::uint32_t>(bytes, static_cast<std::uint32_t>(entry.offset - end));
    end = entry.offset + entry.record_bytes;
  }
  return bytes;
}

// The inverse of table(); `count` is already bounded by the file's size. False where a frame would
// lie outside its room.
bool parse_table(std::string_view bytes, std::uint64_t frames_begin, std::uint64_t frames_end,
                 std::vector<IndexEntry>& entries) {
  ByteTaker taker(bytes);
  for (IndexEntry& entry : entries) entry.numbers.time_s = taker.take<double>();
  for (IndexEntry& entry : entries) entry.numbers.worst_strain = taker.take<double>();
  for (IndexEntry& entry : entries) entry.numbers.penetrating_edges = taker.take<std::uint32_t>();
  for (IndexEntry& entry : entries) entry.numbers.recovery_iterations = taker.take<std::uint32_t>();
  for (IndexEntry& entry : entries) entry.frames_since_key = taker.take<std::uint32_t>();
  for (IndexEntry& entry : entries) entry.record_bytes = taker.take<std::uint32_t>();
  std::uint64_t end = frames_begin;
  for (IndexEntry& entry : entries) {
    entry.offset = end + taker.take<std::uint32_t>();
    end = entry.offset + entry.record_bytes;
    if (entry.record_bytes < smallest_frame_record || end > frames_end) return false;
  }
  return true;
}

}  // namespace

std::string index_payload(std::uint32_t recording_id, const std::vector<IndexEntry>& entries,
                          std::uint64_t frames_begin) {
  const std::string content = table(entries, frames_begin);
  const std::string compressed =
      Compressor().compress(std::array<std::string_view, 1>{std::string_view(content)});
  std::string bytes;
  put<std::uint32_t>(bytes, recording_id);
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(entries.size()));
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(compressed.size()));
  return bytes + compressed;
}

std::optional<std::vector<IndexEntry>> parse_index_payload(std::string_view payload,
                                                           std::uint32_t recording_id,
                                                           std::uint64_t frames_begin,
                                                           std::uint64_t frames_end) {
  ByteTaker taker(payload);
  const auto id = taker.take<std::uint32_t>();
  const auto count = taker.take<std::uint32_t>();
  const auto compressed = taker.take_bytes(taker.take<std::uint32_t>());
  if (!taker.complete() || id != recording_id || frames_end < frames_begin ||
      count > (frames_end - frames_begin) / smallest_frame_record)
    return std::nullopt;
  Decompressor decompressor;
  const auto content = decompressor.decompress(compressed, count * table_row_bytes);
  if (!content || content->size() != count * table_row_bytes) return std::nullopt;
  std::vector<IndexEntry> entries(count);
  if (!parse_table(*content, frames_begin, frames_end, entries)) return std::nullopt;
  return entries;
}

std::string footer_payload(std::uint32_t recording_id, std::uint64_t index_offset) {
  std::string bytes;
  put<std::uint64_t>(bytes, index_offset);
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
