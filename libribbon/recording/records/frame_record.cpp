#include "recording/records/frame_record.h"

#include "recording/coding/bytes.h"

namespace ribbon {

namespace {

constexpr std::uint32_t has_tightness = 1;
constexpr std::uint32_t has_stage = 2;
constexpr std::uint32_t has_reference = 4;

}  // namespace

std::string frame_payload(const FrameRecord& record) {
  const FrameNumbers& numbers = record.numbers;
  std::string more;
  if (record.reference) put<std::uint32_t>(more, *record.reference);
  for (const TightnessColumn& column : tightness_columns)
    if (numbers.tightness) put<float>(more, *numbers.tightness.*column.value);
  if (numbers.stage != 0) put<std::uint8_t>(more, numbers.stage);
  const std::size_t geometry_at = frame_fields_bytes + more.size();
  std::string bytes;
  bytes.reserve(geometry_at + record.geometry.size());
  put<std::uint32_t>(bytes, record.recording_id);
  put<std::uint32_t>(bytes, record.frame);
  put<std::uint16_t>(bytes, static_cast<std::uint16_t>(geometry_at));
  put<std::uint16_t>(bytes, static_cast<std::uint16_t>(record.encoding));
  put<std::uint32_t>(bytes, (numbers.tightness ? has_tightness : 0) |
                                (numbers.stage != 0 ? has_stage : 0) |
                                (record.reference ? has_reference : 0));
  put<double>(bytes, numbers.time_s);
  put<double>(bytes, numbers.worst_strain);
  put<std::uint32_t>(bytes, numbers.penetrating_edges);
  put<std::uint32_t>(bytes, numbers.recovery_iterations);
  return bytes.append(more).append(record.geometry);
}

std::optional<FrameRecord> parse_frame_payload(std::string_view payload) {
  ByteTaker taker(payload);
  FrameRecord record;
  FrameNumbers& numbers = record.numbers;
  record.recording_id = taker.take<std::uint32_t>();
  record.frame = taker.take<std::uint32_t>();
  const auto geometry_at = taker.take<std::uint16_t>();
  const auto encoding = taker.take<std::uint16_t>();
  const auto flags = taker.take<std::uint32_t>();
  numbers.time_s = taker.take<double>();
  numbers.worst_strain = taker.take<double>();
  numbers.penetrating_edges = taker.take<std::uint32_t>();
  numbers.recovery_iterations = taker.take<std::uint32_t>();
  if ((flags & has_reference) != 0) record.reference = taker.take<std::uint32_t>();
  if ((flags & has_tightness) != 0) numbers.tightness.emplace();
  for (const TightnessColumn& column : tightness_columns)
    if (numbers.tightness) *numbers.tightness.*column.value = taker.take<float>();
  if ((flags & has_stage) != 0) numbers.stage = taker.take<std::uint8_t>();
  // What later versions know may stand before the geometry.
  if (!taker.complete() || encoding > 1 || geometry_at < payload.size() - taker.rest().size() ||
      geometry_at > payload.size())
    return std::nullopt;
  record.encoding = static_cast<FrameEncoding>(encoding);
  record.geometry = payload.substr(geometry_at);
  return record;
}

}  // namespace ribbon
