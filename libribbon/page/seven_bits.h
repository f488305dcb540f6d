// Bytes as text that may stand in a script of a page, denser than base64.
#pragma once

#include <string>
#include <string_view>

namespace ribbon {

// Seven bits a letter, the highest first, the last ones filled up with 0: the letter U+0000 and as
// many more, or, of those that a page would change or that could end a script or a place in a page,
// 256 more than that. UTF-8: about 1.18 bytes for each.
std::string seven_bits(std::string_view bytes);

}  // namespace ribbon
