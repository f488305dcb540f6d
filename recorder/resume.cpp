#include "recorder/resume.h"

#include <algorithm>
#include <utility>

#include "continuation/resume_recording.h"
#include "recorder/run/recorded_run.h"
#include "recorder/run/stopwatch.h"
#include "scene/setting.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

namespace fs = std::filesystem;

bool has_checkpoint_of(const RecordingReader& reader, int index) {
  const auto checkpoints = reader.checkpoints();
  return std::find(checkpoints.begin(), checkpoints.end(), static_cast<std::uint32_t>(index)) !=
         checkpoints.end();
}

// Did it end before its duration was over, because there was nothing more to pull?
bool has_ended_by_itself(const RecordingReader& reader) {
  return reader.ending() == RunEnding::tight || reader.ending() == RunEnding::stages_over;
}

bool is_slipping(const RecordingReader& reader) {
  return reader.ending() == RunEnding::first_end_slips ||
         reader.ending() == RunEnding::second_end_slips;
}

bool has_come_to_its_end(const RecordingReader& reader) {
  return reader.finished() && reader.ending() != RunEnding::stopped &&
         reader.ending() != RunEnding::limit;
}

// Has the run got to the end of its scene, or of the limit? One whose end slips is not drawn on.
bool is_done(const RecordingReader& reader, const RunPlan& plan) {
  if (!reader.finished()) return false;
  if (is_slipping(reader) || (plan.until_tight() && has_ended_by_itself(reader))) return true;
  return reader.frame_count() >= plan.frames;
}

// A run that is to go on.
struct Continuation {
  RecordedRun run;
  RunPlan plan;
  std::string changed_settings;
};

// A limit beyond the end of the scene extends it, and then the ribbon may be tight before.
Result<Continuation> continuation(const fs::path& path, const RunLimit& limit) {
  auto run = RecordedRun::open(path);
  if (!run) return tl::unexpected(run.error());
  auto plan = plan_of(run->scene, limit);
  if (!plan) return tl::unexpected(plan.error());
  if (plan->is_cut_short && run->reader.frame_count() > plan->frames)
    return failure(path.string(),
                   filled_in("it holds {} frames already, more than the {} asked for",
                             run->reader.frame_count(), plan->frames),
                   "ask for more, or branch a shorter take off with --from");
  std::string changed;
  if (plan->frames > frame_count(run->scene))
    changed = setting_of("time.duration", plan->scene.time.duration_s) + "\n";
  if (limit.is_set() && plan->until_tight() && has_ended_by_itself(run->reader)) {
    changed += std::string(drawn_on) + "\n";
    plan->scene.time.until = RunsUntil::duration;
  }
  return Continuation{*std::move(run), *std::move(plan), std::move(changed)};
}

}  // namespace

std::string nothing_to_add(const fs::path& path) {
  const auto reader = RecordingReader::open(path);
  if (reader && is_slipping(*reader))
    return "there is nothing to add: an end of the ribbon would slip out of its knot; branch off "
           "before that by --from, with a hand that holds it";
  return "there is nothing to add; extend it with --until or --frames";
}

Result<std::optional<RunStatistics>> resume(const fs::path& path, const std::string& program,
                                            const RunObserver& observer, const RunLimit& limit) {
  {
    const auto wanted = continuation(path, limit);
    if (!wanted) return tl::unexpected(wanted.error());
    const RecordingReader& reader = wanted->run.reader;
    if (!reader.is_being_written() && is_done(reader, wanted->plan)) return std::nullopt;
  }
  // From here on nobody else writes it.
  auto target = resume_recording(path);
  if (!target) return tl::unexpected(target.error());
  auto wanted = continuation(path, limit);
  if (!wanted) return tl::unexpected(wanted.error());
  auto& [recorded, plan, changed_settings] = *wanted;
  const RecordingReader& reader = recorded.reader;
  const int last = reader.frame_count() - 1;
  Stopwatch stopwatch;
  auto before = recorded.simulated_again(last, observer.frame_simulated_again);
  if (!before) return tl::unexpected(before.error());
  RunStatistics statistics = statistics_of(reader, reader.frame_count());
  statistics.start_s = stopwatch.lap();
  if (!*before) {
    statistics.ending = RunEnding::stopped;
    return statistics;
  }
  SimulatedFrames onward(plan.scene, std::move((*before)->fastening()), last);
  BackgroundWriter file(*std::move(target));
  if (ending_at(onward, plan) == RunEnding::unknown) {
    file.append_session(
        {.reason = has_come_to_its_end(reader) ? SessionReason::extended : SessionReason::resumed,
         .program = program,
         .changed_settings = changed_settings});
  }
  return run(onward, plan, has_checkpoint_of(reader, last), file, observer, statistics);
}

}  // namespace ribbon
