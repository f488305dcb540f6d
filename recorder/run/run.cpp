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
  return plan.is_cut_short ? RunEnding::limit : RunEnding::duration;
}

Run::Run(SimulatedFrames& frames, const RunPlan& plan, bool has_checkpoint, BackgroundWriter& file,
         RunStatistics statistics)
    : frames_(frames),
      plan_(plan),
      has_checkpoint_(has_checkpoint),
      file_(file),
      statistics_(std::move(statistics)) {}

void Run::checkpoint() {
  FasteningProcessor& fastening = frames_.fastening();
  file_.append_checkpoint(static_cast<std::uint64_t>(fastening.steps()), fastening.state());
  has_checkpoint_ = true;
}

Result<FrameNumbers> Run::next() {
  const SimulatedFrame frame = frames_.next();
  if (auto near = check_reach(frame, frames_.fastening()); !near)
    return tl::unexpected(near.error());
  Stopwatch stopwatch;
  file_.append(frame.numbers, frame.positions);
  has_checkpoint_ = false;
  if (is_due(frame.index, frames_.frames_per_second(), plan_.scene.recording.checkpoint_every_s))
    checkpoint();
  if (auto written = file_.problem(); !written) return tl::unexpected(written.error());
  statistics_.recording_s += stopwatch.lap();
  statistics_.add(frame.numbers);
  return frame.numbers;
}

Result<RunStatistics> Run::finish(RunEnding ending) {
  Stopwatch stopwatch;
  if (!has_checkpoint_) checkpoint();
  if (auto finished = file_.finish(ending); !finished) return tl::unexpected(finished.error());
  statistics_.recording_s += stopwatch.lap();
  const FasteningProcessor& fastening = frames_.fastening();
  statistics_.start = std::string(word_for(fastening.start().kind));
  statistics_.ending = ending;
  statistics_.until_tight = plan_.until_tight();
  for (const int stage : fastening.stages_given_up())
    statistics_.stages_given_up.push_back(plan_.scene.stages[stage].name);
  statistics_.integrator = std::string(word_for(fastening.integrator()));
  statistics_.held_strain = fastening.held_strain();
  statistics_.steps = fastening.steps();
  statistics_.phases = fastening.phase_sums();
  statistics_.bytes = file_.bytes_written();
  statistics_.beside_it = file_.figures();
  statistics_.computed_steps = frames_.effort().steps;
  statistics_.simulation_s = frames_.effort().simulation_s;
  statistics_.measuring_s = frames_.effort().measuring_s;
  return statistics_;
}

Result<RunStatistics> run(SimulatedFrames& frames, const RunPlan& plan, bool has_checkpoint,
                          BackgroundWriter& file, const RunObserver& observer,
                          RunStatistics statistics) {
  Run run(frames, plan, has_checkpoint, file, std::move(statistics));
  RunEnding ending = run.ending();
  while (ending == RunEnding::unknown) {
    const auto numbers = run.next();
    if (!numbers) return tl::unexpected(numbers.error());
    ending = observer.frame_recorded(frames.index() + 1, plan.frames, *numbers)
                 ? run.ending()
                 : RunEnding::stopped;
  }
  return run.finish(ending);
}

}  // namespace ribbon
