// Whether a recording is all that was to be recorded.
#pragma once

#include <string>

#include "playback/recording_reader.h"

namespace ribbon {

// "unfinished: it ends with frame 12, where its recorder was stopped", or is still at work. Empty
// where the run came to its end.
std::string unfinished_text(const RecordingReader& reader);

}  // namespace ribbon
