// A picture that is handed on as it is.
#pragma once

#include <filesystem>
#include <string>

#include "result/result.h"

namespace ribbon {

struct PictureFile {
  std::string bytes;
  std::string media_type;  // "image/png" or "image/jpeg"
  std::string extension;   // ".png" or ".jpg"
  int width = 0;           // pixels
  int height = 0;
  // What files that refer to it call it: a name without a folder, since it lies beside them.
  std::string name = {};
};

// Only looks at kind and size; the pixels are read by whoever opens it. Fails when the file cannot
// be read, is larger than 256 MB, is neither PNG nor JPEG, or states no size or one beyond
// 16384 x 16384.
Result<PictureFile> read_picture_file(const std::filesystem::path& file);

}  // namespace ribbon
