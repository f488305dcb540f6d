// What must be said of a recording whose frames go into other files.
#pragma once

#include <string>
#include <vector>

#include "converter/conversion_job.h"

namespace ribbon {

// One sentence each, without its full stop: that frames which become meshes intersect, and that the
// recording is unfinished, where its last frame is asked for.
std::vector<std::string> remarks_on(const ConversionJob& job);

}  // namespace ribbon
