// A recording is followed while it is being written.
#pragma once

#include "commandline/tool.h"
#include "playback/recording_reader.h"
#include "player/options.h"
#include "result/result.h"

namespace ribbon {

// Tells of each frame, and renders it where pictures are asked for, until the writer ends or the
// user interrupts.
Result<ExitCode> follow_recording(RecordingReader& reader, const Options& options);

}  // namespace ribbon
