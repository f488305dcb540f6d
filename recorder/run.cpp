#include "recorder/run.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>

#include "recorder/stopwatch.h"
#include "scene/setting.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// A frame time that falls on the limit up to rounding is within it.
int frames_within(const Scene& scene, const RunLimit& limit) {
  if (limit.frames) return *limit.frames;
  Scene limited = scene;
  limited.time.duration_s = *limit.until_s;
  return frame_count(limited);
}

// Of frames that are at multiples of the interval, or the first after one.
bool is_due(int frame, double frames_per_second, double every_s) {
  if (frame == 0) return true;
  if (every_s == 0) return false;
  const auto intervals = [&](int index) {
    return std::floor(index / frames_per_second / every_s * (1 + 1e-12));
  };
  return intervals(frame) > intervals(frame - 1);
}

Result<void> check_reach(const SimulatedFrame& frame, const FasteningProcessor& fastening) {
  const double far_m = frame.positions.cwiseAbs().maxCoeff();
  if (!(far_m > fastening.reach_m())) return {};
  return failure("frame " + std::to_string(frame.index + 1),
                 "the ribbon has got " + short_number(far_m) + " m from the origin, beyond the " +
                     short_number(fastening.reach_m()) +
                     " m within which single precision keeps its gap",
                 "set recording.max_position_error above 0");
}

void add_effort(const SimulatedFrames::Effort& effort, const BackgroundFigures& figures,
                RunStatistics& statistics) {
  statistics.computed_steps = effort.steps;
  statistics.simulation_s = effort.simulation_s;
  statistics.measuring_s = effort.measuring_s;
  statistics.writer = {.encoding_s = figures.writer.encoding_s,
                       .writing_s = figures.writer.writing_s,
                       .syncing_s = figures.writer.syncing_s,
                       .longest_queue = static_cast<long>(figures.longest_queue)};
}

}  // namespace

Result<void> check_place(const NewRecording& recording) {
  std::error_code code;
  const bool is_there =
      std::filesystem::exists(std::filesystem::symlink_status(recording.file, code));
  if (!is_there || recording.overwrite == Overwrite::yes ||
      std::filesystem::is_other(recording.file, code))
    return {};
  return failure(recording.file.string(), "exists already",
                 "go on with that recording by --resume, replace it by --force, or name another "
                 "file after -o");
}

std::string settings_text(const std::vector<std::string>& settings) {
  std::string text;
  for (const std::string& setting : settings) text += setting + "\n";
  return text;
}

Result<Scene> extended(const Scene& scene, const RunLimit& limit) {
  const int frames = limit.is_set() ? frames_within(scene, limit) : 0;
  if (frames <= frame_count(scene)) return scene;
  const double duration_s =
      limit.until_s.value_or((frames - 1) / scene.recording.frames_per_second);
  auto longer = read_scene(scene.file, scene.text, {setting_of("time.duration", duration_s)});
  if (longer) longer->name = scene.name;
  return longer;
}

RunPlan plan_of(const Scene& scene, const RunLimit& limit) {
  RunPlan plan{.frames = frame_count(scene),
               .until_tight = scene.time.until == RunsUntil::tight,
               .checkpoint_every_s = scene.recording.checkpoint_every_s};
  if (!limit.is_set()) return plan;
  const int limited = frames_within(scene, limit);
  plan.is_cut_short = limited < plan.frames;
  plan.frames = std::min(plan.frames, limited);
  return plan;
}

RunEnding ending_at(SimulatedFrames& frames, const RunPlan& plan) {
  if (frames.index() < 0) return RunEnding::unknown;
  if (plan.until_tight && frames.fastening().is_tight()) return RunEnding::tight;
  if (frames.index() + 1 < plan.frames) return RunEnding::unknown;
  return plan.is_cut_short ? RunEnding::stopped : RunEnding::duration;
}

Result<RunStatistics> run(SimulatedFrames& frames, const RunPlan& plan, bool has_checkpoint,
                          BackgroundWriter& file, const RunObserver& observer,
                          RunStatistics statistics) {
  Stopwatch stopwatch;
  FasteningProcessor& fastening = frames.fastening();
  const auto checkpoint = [&] {
    file.append_checkpoint(static_cast<std::uint64_t>(fastening.steps()), fastening.state());
    has_checkpoint = true;
  };
  RunEnding ending = ending_at(frames, plan);
  while (ending == RunEnding::unknown) {
    const SimulatedFrame frame = frames.next();
    if (auto near = check_reach(frame, fastening); !near) return tl::unexpected(near.error());
    stopwatch.lap();
    file.append(frame.numbers, frame.positions);
    has_checkpoint = false;
    if (is_due(frame.index, frames.frames_per_second(), plan.checkpoint_every_s)) checkpoint();
    if (auto written = file.problem(); !written) return tl::unexpected(written.error());
    statistics.recording_s += stopwatch.lap();
    statistics.add(frame.numbers);
    ending = observer.frame_recorded(frame.index + 1, plan.frames, frame.numbers)
                 ? ending_at(frames, plan)
                 : RunEnding::stopped;
  }
  stopwatch.lap();
  if (!has_checkpoint) checkpoint();
  if (auto finished = file.finish(ending); !finished) return tl::unexpected(finished.error());
  statistics.recording_s += stopwatch.lap();
  statistics.ending = ending;
  statistics.limit_reached = plan.is_cut_short && ending_at(frames, plan) == RunEnding::stopped;
  statistics.until_tight = plan.until_tight;
  statistics.steps = fastening.steps();
  statistics.stages = fastening.stage_sums();
  statistics.bytes = file.bytes_written();
  add_effort(frames.effort(), file.figures(), statistics);
  return statistics;
}

}  // namespace ribbon
