// The obstacle alone, which does not move.
#pragma once

#include "converter/conversion.h"
#include "converter/conversion_job.h"

namespace ribbon {

// Writes the model of the job, which holds no ribbon, as one OBJ (with its material library) or
// FBX.
Result<ConversionReport> write_still_life(const ConversionRequest& request,
                                          const ConversionJob& job);

}  // namespace ribbon
