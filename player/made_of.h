// What the pixels of a picture depend on.
#pragma once

#include <cstddef>
#include <vector>

#include "playback/recording_reader.h"
#include "player/options.h"
#include "player/output/manifest.h"

namespace ribbon {

// Of each shot, in one line: the recording by its id, size and checksum, this program, the ray
// tracer with its vector instructions, and every option that was given but those that change no
// pixel; of an option that names a file, also that file's checksum; of several views that of the
// shot alone. Reads all of the recording.
Result<std::vector<MadeOf>> made_of(const RecordingReader& reader, const Options& options,
                                    std::size_t shots);

}  // namespace ribbon
