#include "recording/tightness_record.h"

#include "recording/bytes.h"

namespace ribbon {

std::string tightness_payload(const TightnessRecord& record) {
  std::string bytes;
  put<std::uint32_t>(bytes, record.recording_id);
  put<std::uint32_t>(bytes, record.frame);
  for (const auto& column : tightness_columns) put<float>(bytes, record.numbers.*column.value);
  return bytes;
}

std::optional<TightnessRecord> parse_tightness_payload(std::string_view payload) {
  ByteTaker taker(payload);
  TightnessRecord record;
  record.recording_id = taker.take<std::uint32_t>();
  record.frame = taker.take<std::uint32_t>();
  for (const auto& column : tightness_columns) record.numbers.*column.value = taker.take<float>();
  if (!taker.complete()) return std::nullopt;
  return record;
}

}  // namespace ribbon
