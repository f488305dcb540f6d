#include "recording/index_record.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "recording/bytes.h"
#include "recording/compression.h"
#include "recording/frame_record.h"
#include "recording/record.h"

namespace ribbon {

namespace {

constexpr std::uint64_t smallest_frame_record = record_head_bytes + frame_fields_bytes;
constexpr std::size_t table_row_bytes = 36;
constexpr std::size_t tightness_row_bytes = tightness_columns.size() * sizeof(float);

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

void put_block(std::string& bytes, std::string_view content) {
  const std::string compressed = Compressor().compress(std::array<std::string_view, 1>{content});
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(compressed.size()));
  bytes += compressed;
}

// The content of the next block; nothing where it does not hold exactly `size` bytes.
std::optional<std::string> take_block(ByteTaker& taker, std::size_t size) {
  const auto compressed = taker.take_bytes(taker.take<std::uint32_t>());
  Decompressor decompressor;
  const auto content = decompressor.decompress(compressed, size);
  if (!taker.complete() || !content || content->size() != size) return std::nullopt;
  return std::string(*content);
}

bool has_tightness(const IndexEntry& entry) {
  return entry.numbers.tightness.has_value();
}

// What version 1.2 appended.
void put_version_1_2(std::string& bytes, const Index& index) {
  put<std::uint8_t>(bytes, static_cast<std::uint8_t>(index.ending));
  const bool tightness = std::any_of(index.entries.begin(), index.entries.end(), has_tightness);
  put<std::uint8_t>(bytes, tightness ? 1 : 0);
  if (!tightness) return;
  assert(std::all_of(index.entries.begin(), index.entries.end(), has_tightness));
  std::string table;
  for (const TightnessColumn& column : tightness_columns)
    for (const IndexEntry& entry : index.entries)
      put<float>(table, *entry.numbers.tightness.*column.value);
  put_block(bytes, table);
}

// Older indices end before it; endings that this version does not know are as good as none.
bool take_version_1_2(ByteTaker& taker, Index& index) {
  if (taker.rest().empty()) return true;
  const auto ending = taker.take<std::uint8_t>();
  if (ending <= static_cast<std::uint8_t>(RunEnding::stopped))
    index.ending = static_cast<RunEnding>(ending);
  if (taker.take<std::uint8_t>() == 0) return taker.complete();
  const auto table = take_block(taker, index.entries.size() * tightness_row_bytes);
  if (!table) return false;
  ByteTaker numbers(*table);
  for (IndexEntry& entry : index.entries) entry.numbers.tightness.emplace();
  for (const TightnessColumn& column : tightness_columns)
    for (IndexEntry& entry : index.entries)
      *entry.numbers.tightness.*column.value = numbers.take<float>();
  return true;
}

}  // namespace

std::string index_payload(std::uint32_t recording_id, const Index& index,
                          std::uint64_t frames_begin) {
  std::string bytes;
  put<std::uint32_t>(bytes, recording_id);
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(index.entries.size()));
  put_block(bytes, table(index.entries, frames_begin));
  put_version_1_2(bytes, index);
  return bytes;
}

std::optional<Index> parse_index_payload(std::string_view payload, std::uint32_t recording_id,
                                         std::uint64_t frames_begin, std::uint64_t frames_end) {
  ByteTaker taker(payload);
  const auto id = taker.take<std::uint32_t>();
  const auto count = taker.take<std::uint32_t>();
  if (!taker.complete() || id != recording_id || frames_end < frames_begin ||
      count > (frames_end - frames_begin) / smallest_frame_record)
    return std::nullopt;
  const auto content = take_block(taker, count * table_row_bytes);
  if (!content) return std::nullopt;
  Index index;
  index.entries.resize(count);
  if (!parse_table(*content, frames_begin, frames_end, index.entries) ||
      !take_version_1_2(taker, index))
    return std::nullopt;
  return index;
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
