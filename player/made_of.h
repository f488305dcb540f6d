// What the pixels of a picture depend on.
#pragma once

#include <cstddef>

#include "playback/recording_reader.h"
#include "player/options.h"
#include "player/output/manifest.h"

namespace ribbon {

// In one line: the recording by its id, size and checksum, this program, the ray tracer with its
// vector instructions, and every option that was given but those that change no pixel; of an option
// that names a file, also that file's checksum; of several views that of this shot alone.
Result<MadeOf> made_of(const RecordingReader& reader, const Options& options, std::size_t shot);

}  // namespace ribbon
