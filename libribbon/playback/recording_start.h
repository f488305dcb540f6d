// How every recording begins: signature and header (FORMAT.md, sections 1 and 4).
#pragma once

#include <cstdint>
#include <filesystem>

#include "playback/random_access_file.h"
#include "recording/records/recording.h"
#include "result/result.h"

namespace ribbon {

struct RecordingStart {
  RecordingHeader header;
  std::uint32_t recording_id = 0;
  std::uint64_t end = 0;           // where the first record behind the header begins
  bool signature_is_right = true;  // the header alone shows that it is a recording, too
};

struct OpenedRecording {
  RandomAccessFile file;
  RecordingStart start;
};

// Fails when `path` cannot be read, is no recording or its header is not valid.
Result<OpenedRecording> open_recording(const std::filesystem::path& path);

}  // namespace ribbon
