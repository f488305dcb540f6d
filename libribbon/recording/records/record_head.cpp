#include "recording/records/record_head.h"

#include "recording/coding/bytes.h"
#include "recording/coding/checksum.h"
#include "recording/records/checkpoint_record.h"

namespace ribbon {

std::uint64_t most_payload_bytes(RecordType type, const RibbonGrid& grid) {
  constexpr std::uint64_t besides = 1 << 20;
  if (type == RecordType::frame)
    return 256 * static_cast<std::uint64_t>(grid.particle_count()) + besides;
  if (type == RecordType::checkpoint) return 2 * largest_state_bytes(grid) + besides;
  return 1 << 28;
}

std::string make_record(RecordType type, std::string_view payload) {
  std::string bytes(record_magic);
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(type));
  put<std::uint64_t>(bytes, payload.size());
  put<std::uint32_t>(bytes, checksum(payload));
  put<std::uint32_t>(bytes, checksum(bytes));
  bytes += payload;
  return bytes;
}

std::optional<RecordHead> parse_record_head(std::string_view bytes) {
  if (bytes.size() < record_head_bytes || !bytes.starts_with(record_magic)) return std::nullopt;
  ByteTaker taker(bytes.substr(record_magic.size()));
  RecordHead head;
  head.type = static_cast<RecordType>(taker.take<std::uint32_t>());
  head.payload_bytes = taker.take<std::uint64_t>();
  head.payload_checksum = taker.take<std::uint32_t>();
  if (taker.take<std::uint32_t>() != checksum(bytes.substr(0, record_head_bytes - 4)))
    return std::nullopt;
  return head;
}

}  // namespace ribbon
