// Pictures as PNG files.
#pragma once

#include <filesystem>
#include <string>

#include "files/part_file.h"
#include "player/picture/picture.h"
#include "result/result.h"

namespace ribbon {

// The bytes of an 8-bit RGB PNG that says that it is sRGB, packed for speed rather than size: the
// same for the same pixels. The picture must have at least one pixel, and less than 2 GB.
std::string png_bytes(const Picture& picture);

// Those bytes as a file, complete or not at all.
Result<void> write_png(const std::filesystem::path& path, const Picture& picture,
                       Older older = Older::is_replaced);

}  // namespace ribbon
