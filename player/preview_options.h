// What a preview can be asked for.
#pragma once

#include "player/options.h"
#include "result/result.h"

namespace ribbon {

// Fails where something was given that previews do not show. samples: in every pixel, 0 where the
// user does not say.
Result<PreviewSettings> read_preview(const Options& options, int samples);

}  // namespace ribbon
