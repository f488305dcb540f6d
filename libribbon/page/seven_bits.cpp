#include "page/seven_bits.h"

#include <cstdint>

namespace ribbon {

namespace {

constexpr std::string_view not_as_they_are("\0\r<{", 4);

void append_letter(unsigned bits, std::string& text) {
  const auto letter = static_cast<char>(bits);
  if (not_as_they_are.find(letter) == std::string_view::npos) {
    text += letter;
    return;
  }
  // U+0100 + bits in two bytes of UTF-8.
  text += static_cast<char>(0xC4U | bits >> 6U);
  text += static_cast<char>(0x80U | (bits & 0x3FU));
}

}  // namespace

std::string seven_bits(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() / 6 * 7);
  std::uint32_t waiting = 0;
  unsigned count = 0;
  for (const char byte : bytes) {
    waiting = waiting << 8U | static_cast<std::uint8_t>(byte);
    for (count += 8; count >= 7; count -= 7) append_letter(waiting >> (count - 7) & 0x7FU, text);
  }
  if (count > 0) append_letter(waiting << (7 - count) & 0x7FU, text);
  return text;
}

}  // namespace ribbon
