// A new recording, where the obstacle has been read.
#pragma once

#include <optional>

#include "geometry/triangle_mesh.h"
#include "recorder/new_recording.h"
#include "recorder/run/run.h"
#include "recorder/run/run_statistics.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// As record() does, around this obstacle, whatever file the scene names.
Result<RunStatistics> record_around(const std::optional<TriangleMesh>& obstacle, const Scene& scene,
                                    const NewRecording& recording, const RunObserver& observer,
                                    const RunLimit& limit = {});

}  // namespace ribbon
