#include "player/picture/characters.h"

#include <cstddef>

namespace ribbon {

char32_t take_character(std::string_view& text) {
  constexpr char32_t broken = 0xFFFD;
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
  return character;
}

}  // namespace ribbon
