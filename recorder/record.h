// From a scene to a recording: the stations in order.
#pragma once

#include <filesystem>
#include <string>

#include "recorder/run.h"
#include "recorder/run_statistics.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// Generates the ribbon of `scene`, fastens it and records every frame into `recording`. A frame is
// recorded at the first step at or after its time; until = "tight" ends with the first frame in
// which the ribbon is tight. `writer`: program and version, for the header.
// Fails when the drawing, the obstacle, the start or the file does not work. The file is created,
// and an older one of that name replaced, only once there is a start; frames written before stay
// readable.
Result<RunStatistics> record(const Scene& scene, const std::filesystem::path& recording,
                             const std::string& writer, const RunObserver& observer,
                             const RunLimit& limit = {});

}  // namespace ribbon
