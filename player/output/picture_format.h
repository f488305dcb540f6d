// What is written, told by the name of the output.
#pragma once

#include <string>

#include "result/result.h"

namespace ribbon {

enum class PictureFormat {
  png,
  exr,
  video,  // .mp4, .webm or .gif
  raw     // "-": to standard output
};

// By the extension, in upper or lower case. Fails for any other with what can be written instead.
Result<PictureFormat> picture_format(const std::string& output);

// Of a file that holds all frames: fails where its name has a place for their number or the view.
Result<void> check_single_name(const std::string& output);

// Does each picture get a file of its own?
constexpr bool is_one_file_each(PictureFormat format) {
  return format == PictureFormat::png || format == PictureFormat::exr;
}

}  // namespace ribbon
