// Text as characters.
#pragma once

#include <string>
#include <string_view>

namespace ribbon {

// Takes the first character off UTF-8 `text`, which must not be empty. Bytes that are not UTF-8
// become U+FFFD.
char32_t take_character(std::string_view& text);

void append_character(std::string& text, char32_t character);

// The text in UTF-8, whatever bytes it has: names of files may have any.
std::string as_utf8(std::string_view text);

}  // namespace ribbon
