// One file a frame, written by all cores.
#pragma once

#include "converter/conversion.h"
#include "converter/conversion_job.h"

namespace ribbon {

// Writes the frames of `job` as OBJ (with one material library for all) or FBX. With
// request.resume, those that an earlier conversion completed stay.
Result<ConversionReport> write_frame_sequence(const ConversionRequest& request, ConversionJob job);

}  // namespace ribbon
