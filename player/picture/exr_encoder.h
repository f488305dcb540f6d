// Linear light as OpenEXR files.
#pragma once

#include <string>

#include "player/picture/picture.h"

namespace ribbon {

// The bytes of an OpenEXR file with red, green and blue as half floats (11 bits of precision, up to
// 65504) of the sRGB primaries, ZIP-compressed without loss. The picture must have at least one
// pixel.
std::string exr_bytes(const LightPicture& picture);

}  // namespace ribbon
