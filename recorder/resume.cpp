#include "recorder/resume.h"

#include <algorithm>
#include <utility>

#include "continuation/resume_recording.h"
#include "recorder/recorded_run.h"
#include "recorder/stopwatch.h"
#include "scene/setting.h"

namespace ribbon {

namespace {

namespace fs = std::filesystem;

bool has_checkpoint_of(const RecordingReader& reader, int index) {
  const auto checkpoints = reader.checkpoints();
  return std::find(checkpoints.begin(), checkpoints.end(), static_cast<std::uint32_t>(index)) !=
         checkpoints.end();
}

// Has the run got to the end of its scene, or of the limit?
bool is_done(const RecordingReader& reader, const RunPlan& plan) {
  if (!reader.finished()) return false;
  if (plan.until_tight && reader.ending() == RunEnding::tight) return true;
  return reader.frame_count() >= plan.frames;
}

Result<void> check_limit(const fs::path& path, const RecordingReader& reader, const RunPlan& plan) {
  if (!plan.is_cut_short || reader.frame_count() <= plan.frames) return {};
  return failure(path.string(),
                 "it holds " + std::to_string(reader.frame_count()) +
                     " frames already, more than the " + std::to_string(plan.frames) + " asked for",
                 "ask for more, or branch a shorter take off with --from");
}

struct Continuation {
  Scene scene;
  RunPlan plan;
  std::string changed_settings;
};

// A limit beyond the end of the scene extends it, and then the ribbon may be tight before.
Result<Continuation> continuation(const fs::path& path, const RecordingReader& reader,
                                  const RunLimit& limit) {
  const auto recorded = recorded_scene(path, reader);
  if (!recorded) return tl::unexpected(recorded.error());
  auto scene = extended(*recorded, limit);
  if (!scene) return tl::unexpected(scene.error());
  std::string changed;
  if (frame_count(*scene) > frame_count(*recorded))
    changed = setting_of("time.duration", scene->time.duration_s) + "\n";
  const bool was_tight = reader.ending() == RunEnding::tight;
  if (limit.is_set() && was_tight && scene->time.until == RunsUntil::tight) {
    changed += "time.until = \"duration\"\n";
    scene->time.until = RunsUntil::duration;
  }
  const RunPlan plan = plan_of(*scene, limit);
  return Continuation{*std::move(scene), plan, std::move(changed)};
}

}  // namespace

RunStatistics statistics_of(const RecordingReader& reader) {
  const RecordingHeader& header = reader.header();
  RunStatistics statistics;
  statistics.scene_name = header.scene_name;
  statistics.along = header.grid.along;
  statistics.across = header.grid.across;
  for (int frame = 0; frame < reader.frame_count(); ++frame) {
    if (const auto numbers = reader.numbers(frame))
      statistics.add(*numbers);
    else
      ++statistics.frames;
  }
  statistics.first_frame = reader.frame_count();
  return statistics;
}

Result<std::optional<RunStatistics>> resume(const fs::path& path, const std::string& program,
                                            const RunObserver& observer, const RunLimit& limit) {
  {
    const auto reader = RecordingReader::open(path);
    if (!reader) return tl::unexpected(reader.error());
    const auto wanted = continuation(path, *reader, limit);
    if (!wanted) return tl::unexpected(wanted.error());
    if (auto beyond = check_limit(path, *reader, wanted->plan); !beyond)
      return tl::unexpected(beyond.error());
    if (!reader->is_being_written() && is_done(*reader, wanted->plan)) return std::nullopt;
  }
  // From here on nobody else writes it.
  auto target = resume_recording(path);
  if (!target) return tl::unexpected(target.error());
  auto reader = RecordingReader::open(path);
  if (!reader) return tl::unexpected(reader.error());
  const auto wanted = continuation(path, *reader, limit);
  if (!wanted) return tl::unexpected(wanted.error());
  const int last = reader->frame_count() - 1;
  Stopwatch stopwatch;
  auto frames = simulated_again(path, *reader, wanted->scene, last, observer.frame_simulated_again);
  if (!frames) return tl::unexpected(frames.error());
  RunStatistics statistics = statistics_of(*reader);
  statistics.start_s = stopwatch.lap();
  if (!*frames) {
    statistics.ending = RunEnding::stopped;
    return statistics;
  }
  statistics.start = std::string(word_for((*frames)->fastening().start().kind));
  SimulatedFrames onward(wanted->scene, std::move((*frames)->fastening()), last);
  BackgroundWriter file(*std::move(target));
  if (last >= 0 && ending_at(onward, wanted->plan) == RunEnding::unknown) {
    const bool had_ended = reader->finished() && reader->ending() != RunEnding::stopped;
    file.append_session({.reason = had_ended ? SessionReason::extended : SessionReason::resumed,
                         .program = program,
                         .changed_settings = wanted->changed_settings});
  }
  return run(onward, wanted->plan, has_checkpoint_of(*reader, last), file, observer, statistics);
}

}  // namespace ribbon
