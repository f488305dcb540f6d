// A recording of some frames of another one.
#pragma once

#include "converter/conversion.h"
#include "converter/conversion_job.h"

namespace ribbon {

// The header of an excerpt with the frames `kept` (indices from 0, ascending) in which every
// coordinate is within max_error_m of the truth (0: as it was recorded, bit for bit). Where these
// are every nth, they come at an nth of the frame rate.
//
// Coordinates that move by e bring two features nearer to each other by at most 2 sqrt(3) e: by so
// much the stated gap shrinks, and the limit of strain grows. Fails where nothing is left of the
// gap, or the recording is not as exact as is asked for.
Result<RecordingHeader> excerpt_header(const RecordingHeader& source, const std::vector<int>& kept,
                                       double max_error_m, float reach_m);

// Writes the frames of `job` to request.output as a recording, without checkpoints. Frames that
// `job`'s recording has lost are left out and reported.
Result<ConversionReport> write_excerpt(const ConversionRequest& request, ConversionJob job);

}  // namespace ribbon
