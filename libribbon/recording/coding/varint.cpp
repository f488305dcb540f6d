#include "recording/coding/varint.h"

namespace ribbon {

void put_varint(std::string& bytes, std::uint32_t number) {
  for (; number >= 0x80; number >>= 7)
    bytes.push_back(static_cast<char>(static_cast<std::uint8_t>(number | 0x80)));
  bytes.push_back(static_cast<char>(number));
}

std::optional<std::uint32_t> take_varint(std::string_view& bytes) {
  std::uint32_t number = 0;
  for (int shift = 0; shift < 35; shift += 7) {
    if (bytes.empty()) return std::nullopt;
    const auto byte = static_cast<std::uint8_t>(bytes.front());
    bytes.remove_prefix(1);
    number |= static_cast<std::uint32_t>(byte & 0x7F) << shift;
    if (shift == 28 && byte > 0x0F) return std::nullopt;
    if (byte < 0x80) return number;
  }
  return std::nullopt;
}

}  // namespace ribbon
