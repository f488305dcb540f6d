// Goes on with a recording that has ended, however it ended.
#pragma once

#include <filesystem>

#include "recording/writer/recording_writer.h"
#include "result/result.h"

namespace ribbon {

// A writer that appends to `path`, a stopped, killed or finished recording: locks it, cuts off what
// lies behind the last whole record, and writes the next frames as if the first writer had gone on.
// Frames that are lost stay lost. Fails, leaving the file as it is, when it cannot be read or
// written, is no recording, or is being written by another program.
Result<RecordingWriter> resume_recording(const std::filesystem::path& path);

}  // namespace ribbon
