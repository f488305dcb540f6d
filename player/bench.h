// How fast a recording is replayed, stage by stage.
#pragma once

#include <string>

#include "playback/recording_reader.h"
#include "player/options.h"
#include "result/result.h"

namespace ribbon {

// Reads frames in order and out of order, renders the last of them again and again as `options`
// ask, and traces its rays once more by plain calls of Embree. Takes some seconds. Returns a table.
Result<std::string> bench(RecordingReader& reader, const Options& options);

}  // namespace ribbon
