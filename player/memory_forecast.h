// How much memory pictures will take.
#pragma once

#include <cstdint>

#include "player/options.h"
#include "recording/records/recording.h"

namespace ribbon {

// Bytes of memory that rendering with these options takes at most, whatever the number of frames:
// as measured, and a quarter more.
std::uint64_t memory_forecast(const RecordingHeader& header, const Options& options);

}  // namespace ribbon
