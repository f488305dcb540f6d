// Several frames of a recording on one contact sheet.
#pragma once

#include <string>
#include <vector>

#include "playback/recording_reader.h"
#include "player/options.h"
#include "player/report/info.h"
#include "result/result.h"

namespace ribbon {

// Chooses some of `frames` (indices from 0, all readable) and writes options.sheet. Returns one
// line about it.
Result<std::string> write_sheet(RecordingReader& reader, const RecordingInfo& info,
                                const std::vector<int>& frames, const Options& options);

}  // namespace ribbon
