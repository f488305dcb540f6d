// `--frames 1,5,9:20` as users write it.
#pragma once

#include <string>
#include <vector>

#include "result/result.h"

namespace ribbon {

// Frame numbers as users see them, from 1. "7" one frame, "A:B" both ends included, "A:B:STEP",
// either end may be left out, a negative number counts from the end (-1 is the last), B < A with a
// negative STEP runs backwards; several of these with commas between; empty text: all frames. A
// frame that is named again comes only where it was named first. Returns indices from 0 in the
// order asked for. Fails when the text cannot be read or names a frame that the recording does not
// hold.
Result<std::vector<int>> parse_frame_range(const std::string& text, int frame_count);

}  // namespace ribbon
