#include "fuzz/repaired_checksums.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "recording/coding/checksum.h"

namespace ribbon {

namespace {

// FORMAT.md, sections 1, 2 and 7.
constexpr std::size_t signature_bytes = 8;
constexpr std::size_t head_bytes = 24;
constexpr std::array<std::uint8_t, 4> magic = {0xB1, 0x52, 0x45, 0x43};
constexpr std::uint32_t footer_type = 4;
constexpr std::size_t footer_id_at = 8;

template <class Number>
Number at(std::span<const std::uint8_t> bytes, std::size_t offset) {
  Number number{};
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

void put(std::span<std::uint8_t> bytes, std::size_t offset, std::uint32_t number) {
  std::memcpy(bytes.data() + offset, &number, sizeof number);
}

std::uint32_t checksum_of(std::span<const std::uint8_t> bytes) {
  return checksum({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

// record: from its head to its end. Its payload names the recording, unless it is the header.
void repair(std::span<std::uint8_t> record, std::uint32_t recording_id, bool is_header) {
  const auto payload = record.subspan(head_bytes);
  const std::size_t id_at = at<std::uint32_t>(record, 4) == footer_type ? footer_id_at : 0;
  if (!is_header && payload.size() >= id_at + 4) put(payload, id_at, recording_id);
  put(record, 16, checksum_of(payload));
}

}  // namespace

void repair_checksums(std::span<std::uint8_t> file) {
  std::uint32_t recording_id = 0;
  bool is_header = true;
  auto begin = file.begin() + static_cast<std::ptrdiff_t>(std::min(file.size(), signature_bytes));
  while (true) {
    begin = std::search(begin, file.end(), magic.begin(), magic.end());
    if (file.end() - begin < static_cast<std::ptrdiff_t>(head_bytes)) return;
    const std::span<std::uint8_t> rest(begin, file.end());
    const auto payload_bytes = at<std::uint64_t>(rest, 8);
    const bool is_whole = payload_bytes <= rest.size() - head_bytes;
    if (is_whole) repair(rest.first(head_bytes + payload_bytes), recording_id, is_header);
    if (is_whole && is_header) recording_id = at<std::uint32_t>(rest, 16);
    is_header = false;
    put(rest, 20, checksum_of(rest.first(20)));
    begin += static_cast<std::ptrdiff_t>(is_whole ? head_bytes + payload_bytes : head_bytes);
  }
}

}  // namespace ribbon
