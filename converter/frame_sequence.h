// One file a frame, written by all cores.
#pragma once

#include <vector>

#include "converter/conversion.h"
#include "converter/export/model.h"
#include "converter/output_format.h"

namespace ribbon {

// Writes `frames` (indices from 0) of `reader`'s recording as OBJ (with one material library for
// all) or FBX.
Result<ConversionReport> write_frame_sequence(const ConversionRequest& request, OutputFormat format,
                                              RecordingReader reader, const Model& model,
                                              const std::vector<int>& frames);

}  // namespace ribbon
