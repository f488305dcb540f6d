#include "recorder/run/run.h"

#include <cmath>
#include <string>
#include <utility>

#include "recorder/run/stopwatch.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

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
  return failure(
      filled_in("frame {}", frame.index + 1),
      filled_in("the ribbon has got {:.6g} m from the origin, beyond the {:.6g} m within "
                "which single precision keeps its gap",
                far_m, fastening.reach_m()),
      "set recording.max_position_error above 0");
}

}  // namespace

RunEnding ending_at(SimulatedFrames& frames, const RunPlan& plan) {
  if (frames.index() < 0) return RunEnding::unknown;
  const FasteningProcessor& fastening = frames.fastening();
  if (const auto end = fastening.slipping_end())
    return *end == 0 ? RunEnding::first_end_slips : RunEnding::second_end_slips;
  if (plan.until_tight() && fastening.is_tight()) return RunEnding::tight;
  if (plan.until_tight() && fastening.stages_are_over()) return RunEnding::stages_over;
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
    if (is_due(frame.index, frames.frames_per_second(), plan.scene.recording.checkpoint_every_s))
      checkpoint();
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
  statistics.start = std::string(word_for(fastening.start().kind));
  statistics.ending = ending;
  statistics.limit_reached = plan.is_cut_short && ending_at(frames, plan) == RunEnding::stopped;
  statistics.until_tight = plan.until_tight();
  statistics.steps = fastening.steps();
  statistics.stages = fastening.stage_sums();
  statistics.bytes = file.bytes_written();
  statistics.beside_it = file.figures();
  statistics.computed_steps = frames.effort().steps;
  statistics.simulation_s = frames.effort().simulation_s;
  statistics.measuring_s = frames.effort().measuring_s;
  return statistics;
}

}  // namespace ribbon
