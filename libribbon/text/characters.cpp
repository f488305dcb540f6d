#include "text/characters.h"

#include <array>
#include <cstddef>

namespace ribbon {

char32_t take_character(std::string_view& text) {
  constexpr char32_t broken = 0xFFFD;
  constexpr std::array<char32_t, 4> least = {0, 0x80, 0x800, 0x10000};  // in so many more bytes
  const auto first = static_cast<unsigned char>(text[0]);
  text.remove_prefix(1);
  if (first < 0x80) return first;
  const std::size_t more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
  if (first < 0xC2 || first > 0xF4 || text.size() < more) return broken;
  char32_t character = first & (0x3FU >> more);
  for (std::size_t i = 0; i < more; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0U) != 0x80) return broken;
    character = character << 6U | (byte & 0x3FU);
  }
  text.remove_prefix(more);
  const bool is_surrogate = character >= 0xD800 && character < 0xE000;
  return character < least[more] || is_surrogate || character > 0x10FFFF ? broken : character;
}

void append_character(std::string& text, char32_t character) {
  const auto append = [&text](char32_t byte) { text += static_cast<char>(byte); };
  const auto follow = [&](int shift) { append(0x80 | ((character >> shift) & 0x3F)); };
  if (character < 0x80) return append(character);
  if (character < 0x800) {
    append(0xC0 | (character >> 6));
    return follow(0);
  }
  if (character < 0x10000) {
    append(0xE0 | (character >> 12));
  } else {
    append(0xF0 | (character >> 18));
    follow(12);
  }
  follow(6);
  follow(0);
}

std::string as_utf8(std::string_view text) {
  std::string utf8;
  while (!text.empty()) append_character(utf8, take_character(text));
  return utf8;
}

}  // namespace ribbon
