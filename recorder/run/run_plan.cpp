#include "recorder/run/run_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "scene/setting.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// A frame time that falls on the end up to rounding is within it. No scene may have as many as an
// int holds.
int frames_within(double duration_s, double frames_per_second) {
  constexpr double most = std::numeric_limits<int>::max() - 1;
  const double after_first = std::floor(duration_s * frames_per_second * (1 + 1e-12));
  return static_cast<int>(std::min(after_first, most)) + 1;
}

// The first frame tells the start; a run that ends before the next would tell no more.
Result<RunPlan> with_frames(RunPlan plan) {
  if (plan.frames > 1) return plan;
  return failure(plan.scene.name,
                 "the run would be over before its second frame, which comes after " +
                     shortest(1 / plan.scene.recording.frames_per_second) + " s",
                 "let it last longer, or set a larger recording.frames_per_second");
}

}  // namespace

Result<RunPlan> plan_of(const Scene& scene, const RunLimit& limit) {
  const double frames_per_second = scene.recording.frames_per_second;
  RunPlan plan{scene, frame_count(scene)};
  if (!limit.is_set()) return with_frames(std::move(plan));
  const int limited =
      limit.frames ? *limit.frames : frames_within(*limit.until_s, frames_per_second);
  if (limited > plan.frames) {
    const double duration_s = limit.until_s.value_or((limited - 1) / frames_per_second);
    auto longer =
        read_scene(scene.file, scene.text, {setting_of("time.duration", duration_s)}, scene.name);
    if (!longer) {
      longer.error().place = limit.until_s ? "--until " + shortest(*limit.until_s)
                                           : "--frames " + std::to_string(*limit.frames);
      return tl::unexpected(longer.error());
    }
    const int frames = frame_count(*longer);
    plan = {*std::move(longer), frames};
  }
  plan.is_cut_short = limited < plan.frames;
  plan.frames = std::min(plan.frames, limited);
  return with_frames(std::move(plan));
}

int frame_count(const Scene& scene) {
  return frames_within(scene.time.duration_s, scene.recording.frames_per_second);
}

}  // namespace ribbon
