// Which format an output name asks for, and why some are refused.
#pragma once

#include <string>

#include "result/result.h"

namespace ribbon {

// OBJ and FBX hold one frame a file; the others hold all frames in one, as FBX does where it is
// asked for a whole motion.
enum class OutputFormat { obj, fbx, whole_motion, numbers, recording };

inline bool is_one_file(OutputFormat format) {
  return format != OutputFormat::obj && format != OutputFormat::fbx;
}

// Told by the extension, in upper or lower case. Fails for any other with what is written instead,
// and with the reason where the format is one that users ask for.
Result<OutputFormat> output_format(const std::string& output);

}  // namespace ribbon
