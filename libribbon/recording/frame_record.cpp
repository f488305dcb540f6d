#include "recording/frame_record.h"

#include "recording/bytes.h"

namespace ribbon {

std::string frame_payload(const FrameRecord& record) {
  std::string bytes;
  bytes.reserve(frame_fields_bytes + record.geometry.size());
  put<std::uint32_t>(bytes, record.recording_id);
  put<std::uint32_t>(bytes, record.frame);
  put<std::uint32_t>(bytes, record.frames_since_key);
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(record.encoding));
  put<double>(bytes, record.numbers.time_s);
  put<double>(bytes, record.numbers.worst_strain);
  put<std::uint32_t>(bytes, record.numbers.penetrating_edges);
  put<std::uint32_t>(bytes, record.numbers.recovery_iterations);
  bytes += record.geometry;
  return bytes;
}

std::optional<FrameRecord> parse_frame_payload(std::string_view payload) {
  ByteTaker taker(payload);
  FrameRecord record;
  record.recording_id = taker.take<std::uint32_t>();
  record.frame = taker.take<std::uint32_t>();
  record.frames_since_key = taker.take<std::uint32_t>();
  const auto encoding = taker.take<std::uint32_t>();
  record.encoding = static_cast<FrameEncoding>(encoding);
  record.numbers.time_s = taker.take<double>();
  record.numbers.worst_strain = taker.take<double>();
  record.numbers.penetrating_edges = taker.take<std::uint32_t>();
  record.numbers.recovery_iterations = taker.take<std::uint32_t>();
  record.geometry = taker.rest();
  if (!taker.complete() || encoding > 1) return std::nullopt;
  return record;
}

}  // namespace ribbon
