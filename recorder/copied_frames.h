// Frames of recordings that are copied.
#pragma once

#include <optional>

#include "playback/recording_reader.h"

namespace ribbon {

// The first of so many frames, from 0, of which geometry or numbers are lost. Reads every record.
std::optional<int> first_lost_frame(RecordingReader& reader, int count);

// Has a frame of both recordings the same bits and numbers? Not where one cannot read it.
bool same_frame(RecordingReader& a, RecordingReader& b, int frame);

}  // namespace ribbon
