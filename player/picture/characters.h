// Text as characters.
#pragma once

#include <string_view>

namespace ribbon {

// Takes the first character off UTF-8 `text`, which must not be empty. Bytes that are not UTF-8
// become U+FFFD.
char32_t take_character(std::string_view& text);

}  // namespace ribbon
