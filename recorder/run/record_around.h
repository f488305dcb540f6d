// A new recording, where the obstacle has been read.
#pragma once

#include <memory>
#include <optional>

#include "geometry/triangle_mesh.h"
#include "recorder/run/new_recording.h"
#include "recorder/run/run.h"
#include "recorder/run/run_plan.h"
#include "recorder/run/run_statistics.h"
#include "recorder/run/simulated_frames.h"
#include "recording/writer/background_writer.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// A recording that has been begun: all that a Run needs. It stays where it is.
struct BegunRun {
  RunPlan plan;
  BackgroundWriter file;
  SimulatedFrames frames;
  RunStatistics statistics;
};

// Finds the start and creates the file, as record() does. Nothing has been recorded yet.
Result<std::unique_ptr<BegunRun>> begin_recording(const std::optional<TriangleMesh>& obstacle,
                                                  const Scene& scene, const NewRecording& recording,
                                                  const StartObserver& observer,
                                                  const RunLimit& limit = {});

// As record() does, around this obstacle, whatever file the scene names.
Result<RunStatistics> record_around(const std::optional<TriangleMesh>& obstacle, const Scene& scene,
                                    const NewRecording& recording, const RunObserver& observer,
                                    const RunLimit& limit = {});

}  // namespace ribbon
