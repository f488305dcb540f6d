// A recording as a page that plays it.
#pragma once

#include <filesystem>
#include <string>

#include "playback/recording_reader.h"
#include "result/result.h"

namespace ribbon {

// Writes one file that plays `recording` in any browser and loads nothing else. Returns one line
// about it. Fails where this program has no page to put it into, and where a file cannot be read or
// written.
Result<std::string> write_page(const RecordingReader& reader,
                               const std::filesystem::path& recording,
                               const std::filesystem::path& page);

}  // namespace ribbon
