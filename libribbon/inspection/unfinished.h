// Whether a recording is all there.
#pragma once

#include <string>

#include "playback/recording_reader.h"

namespace ribbon {

// "unfinished: ends with frame 12", of a recording whose recorder was stopped on the way or is
// still at work. Empty of one that is finished.
std::string unfinished_text(const RecordingReader& reader);

}  // namespace ribbon
