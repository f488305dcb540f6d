// Bytes as text that may stand in a page (RFC 4648, section 4).
#pragma once

#include <string>
#include <string_view>

namespace ribbon {

// Four letters for three bytes. Texts of pieces can be put together where all pieces but the last
// have a multiple of three bytes.
std::string base64(std::string_view bytes);

}  // namespace ribbon
