// A recording as a page that plays it.
#pragma once

#include <filesystem>
#include <string>

#include "files/part_file.h"
#include "playback/recording_reader.h"
#include "player/output/reader_pipe.h"
#include "result/result.h"

namespace ribbon {

// Writes one file that plays `recording` in any browser and loads nothing else. Returns one line
// about it. Fails where this program has no page to put it into, where a file cannot be read or
// written, where an older page stays, and once `stopped`; then nothing is left behind.
Result<std::string> write_page(const RecordingReader& reader,
                               const std::filesystem::path& recording,
                               const std::filesystem::path& page, Older older,
                               const Stopped& stopped);

}  // namespace ribbon
