// All frames in one point cache beside the OBJ that it deforms.
#pragma once

#include <vector>

#include "converter/conversion.h"
#include "converter/export/model.h"

namespace ribbon {

// Writes `frames` (indices from 0) of the ribbon to request.output (.pc2), and with the same name
// the first of them as .obj with its .mtl. A frame that the recording lost is held from the one
// before it (or, at the start, after it), so that the others keep their time.
Result<ConversionReport> write_cached_animation(const ConversionRequest& request,
                                                RecordingReader reader, Model model,
                                                const std::vector<int>& frames);

}  // namespace ribbon
