// From a scene to a recording: reads the obstacle; record_around.h has the stations in order.
#pragma once

#include "recorder/run/new_recording.h"
#include "recorder/run/run.h"
#include "recorder/run/run_statistics.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// Generates the ribbon of `scene`, fastens it and records every frame. A frame is recorded at the
// first step at or after its time; until = "tight" ends with the first frame in which the ribbon is
// tight. The recording's settings are those that the scene has been changed by, for the file to
// tell. Fails when the drawing, the obstacle, the start or the file does not work, and where an
// older file is not to be replaced. The file is created only once there is a start; frames written
// before a failure stay readable.
Result<RunStatistics> record(const Scene& scene, const NewRecording& recording,
                             const RunObserver& observer, const RunLimit& limit = {});

}  // namespace ribbon
