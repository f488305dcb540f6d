// The page that plays recordings, part of the program.
#pragma once

#include <string_view>

namespace ribbon {

// Complete but for {{title}}, {{file}} and {{recording}}. Empty where the program was built without
// Emscripten.
std::string_view viewer_page();

}  // namespace ribbon
