// What a page unpacks once it is opened.
#pragma once

#include <string>
#include <string_view>

namespace ribbon {

// Compressed by gzip, which browsers know, as seven_bits().
std::string packed(std::string_view bytes);

}  // namespace ribbon
