// Pictures as PNG files.
#pragma once

#include <string>

#include "player/picture/picture.h"

namespace ribbon {

// The bytes of an 8-bit RGB PNG that says that it is sRGB, packed for speed rather than size. The
// picture must have at least one pixel.
std::string png_bytes(const Picture& picture);

}  // namespace ribbon
