// The page in which knots are drawn, part of the program.
#pragma once

#include <string_view>

namespace ribbon {

// Complete but for {{scene}}, the scene to begin with, where there is one; then what stands between
// {{offered}} and {{offered-end}} is not needed. Empty where the program was built without
// Emscripten.
std::string_view sketch_page();

}  // namespace ribbon
