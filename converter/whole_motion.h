// All frames in one file.
#pragma once

#include "converter/conversion.h"
#include "converter/conversion_job.h"

namespace ribbon {

// Writes the frames of `job` to request.output, and where the format holds positions alone, the
// first of them under the same name as .obj with its .mtl. A frame that the recording lost, or
// that cannot be made a solid, is held from the one before it (or, at the start, after it), so that
// the others keep their time.
Result<ConversionReport> write_whole_motion(const ConversionRequest& request, ConversionJob job);

}  // namespace ribbon
