#include "recording/records/frame_record.h"

#include "recording/coding/bytes.h"

namespace ribbon {

namespace {

constexpr std::uint32_t has_tightness = 1;
constexpr std::uint32_t has_stage = 2;

std::uint32_t flags_of(const FrameNumbers& numbers) {
  return (numbers.tightness ? has_tightness : 0) | (numbers.stage != 0 ? has_stage : 0);
}

std::size_t geometry_offset(const FrameRecord& record) {
  return frame_fields_bytes + sizeof(std::uint32_t) * record.references.size() +
         (record.numbers.tightness ? sizeof(float) * tightness_columns.size() : 0) +
         (record.numbers.stage != 0 ? sizeof(record.numbers.stage) : 0);
}

void put_tightness(std::string& bytes, const TightnessNumbers& numbers) {
  for (const TightnessColumn& column : tightness_columns) put<float>(bytes, numbers.*column.value);
}

TightnessNumbers take_tightness(ByteTaker& taker) {
  TightnessNumbers numbers;
  for (const TightnessColumn& column : tightness_columns)
    numbers.*column.value = taker.take<float>();
  return numbers;
}

}  // namespace

std::string frame_payload(const FrameRecord& record) {
  std::string bytes;
  const std::size_t geometry_at = geometry_offset(record);
  bytes.reserve(geometry_at + record.geometry.size());
  put<std::uint32_t>(bytes, record.recording_id);
  put<std::uint32_t>(bytes, record.frame);
  put<std::uint16_t>(bytes, static_cast<std::uint16_t>(geometry_at));
  put<std::uint8_t>(bytes, static_cast<std::uint8_t>(record.encoding));
  put<std::uint8_t>(bytes, static_cast<std::uint8_t>(record.references.size()));
  put<std::uint32_t>(bytes, flags_of(record.numbers));
  put<double>(bytes, record.numbers.time_s);
  put<double>(bytes, record.numbers.worst_strain);
  put<std::uint32_t>(bytes, record.numbers.penetrating_edges);
  put<std::uint32_t>(bytes, record.numbers.recovery_iterations);
  for (const std::uint32_t reference : record.references) put<std::uint32_t>(bytes, reference);
  if (record.numbers.tightness) put_tightness(bytes, *record.numbers.tightness);
  if (record.numbers.stage != 0) put<std::uint8_t>(bytes, record.numbers.stage);
  bytes += record.geometry;
  return bytes;
}

std::optional<FrameRecord> parse_frame_payload(std::string_view payload) {
  ByteTaker taker(payload);
  FrameRecord record;
  record.recording_id = taker.take<std::uint32_t>();
  record.frame = taker.take<std::uint32_t>();
  const auto geometry_at = taker.take<std::uint16_t>();
  const auto encoding = taker.take<std::uint8_t>();
  const auto references = taker.take<std::uint8_t>();
  const auto flags = taker.take<std::uint32_t>();
  record.numbers.time_s = taker.take<double>();
  record.numbers.worst_strain = taker.take<double>();
  record.numbers.penetrating_edges = taker.take<std::uint32_t>();
  record.numbers.recovery_iterations = taker.take<std::uint32_t>();
  if (encoding > 1 || references > most_references) return std::nullopt;
  record.encoding = static_cast<FrameEncoding>(encoding);
  for (int i = 0; i < references; ++i) record.references.push_back(taker.take<std::uint32_t>());
  if ((flags & has_tightness) != 0) record.numbers.tightness = take_tightness(taker);
  if ((flags & has_stage) != 0) record.numbers.stage = taker.take<std::uint8_t>();
  // What later versions know may stand before the geometry.
  if (!taker.complete() || geometry_at < geometry_offset(record) || geometry_at > payload.size())
    return std::nullopt;
  record.geometry = payload.substr(geometry_at);
  return record;
}

}  // namespace ribbon
