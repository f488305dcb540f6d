// The files that a conversion writes.
#pragma once

#include "converter/conversion_job.h"
#include "converter/output_place.h"
#include "result/result.h"

namespace ribbon {

// Frames come in their order. Fails when the output has no good place for their numbers, or
// replaces what is read: the recording, or a picture.
Result<PlannedFiles> planned_files(const ConversionRequest& request, const ConversionJob& job);

}  // namespace ribbon
