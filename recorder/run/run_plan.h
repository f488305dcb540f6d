// How far a run goes.
#pragma once

#include <optional>

#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// Where the user wants a run to end, whatever the scene says; at most one of the two.
struct RunLimit {
  std::optional<double> until_s = std::nullopt;  // simulated time, > 0
  std::optional<int> frames = std::nullopt;      // of the whole recording, at least 2

  [[nodiscard]] bool is_set() const { return until_s || frames; }
};

struct RunPlan {
  Scene scene;                // lasts until the limit, if that is beyond its duration
  int frames = 0;             // how many the recording is to hold in the end
  bool is_cut_short = false;  // are these fewer than the scene wants?

  [[nodiscard]] bool until_tight() const { return scene.time.until == RunsUntil::tight; }
};

// Fails where no frame would follow the first.
Result<RunPlan> plan_of(const Scene& scene, const RunLimit& limit = {});

// One frame at the start of `scene` and then one for each frame time up to its duration.
int frame_count(const Scene& scene);

}  // namespace ribbon
