// The run itself: frame after frame into a recording.
#pragma once

#include <functional>

#include "recorder/run/run_plan.h"
#include "recorder/run/run_statistics.h"
#include "recorder/run/simulated_frames.h"
#include "recording/writer/background_writer.h"
#include "result/result.h"

namespace ribbon {

// What a run tells while it goes on.
struct RunObserver {
  // After each recorded frame: how many of how many, and its numbers. Returns false to end early.
  std::function<bool(int done, int total, const FrameNumbers& numbers)> frame_recorded;
  // After each frame that is simulated again to get to where a recording ended: how many of how
  // many, of these. Returns false to give up. May be empty.
  std::function<bool(int done, int total)> frame_simulated_again = {};
  // Before the first frame, as the search for a start goes on: what becomes of the ribbon. May be
  // empty.
  StartObserver start_sought = {};
};

// What has ended a run that has got to where `frames` stands; unknown: nothing yet.
RunEnding ending_at(SimulatedFrames& frames, const RunPlan& plan);

// Records one frame after the other, with a checkpoint at each multiple of the scene's interval,
// one with the first frame of all and one with the last.
class Run {
 public:
  // All that it borrows lives as long. has_checkpoint: is there one of the frame at which `frames`
  // stands? Adds to `statistics`, which know what there was before.
  Run(SimulatedFrames& frames, const RunPlan& plan, bool has_checkpoint, BackgroundWriter& file,
      RunStatistics statistics);

  // What has ended it; unknown: nothing yet.
  [[nodiscard]] RunEnding ending() { return ending_at(frames_, plan_); }
  // Simulates and records the next frame. Fails where the file does, and where a ribbon that is
  // recorded without loss gets out of the reach in which its gap is guaranteed.
  Result<FrameNumbers> next();
  // Finishes the file. Once.
  Result<RunStatistics> finish(RunEnding ending);

 private:
  void checkpoint();

  SimulatedFrames& frames_;
  const RunPlan& plan_;
  bool has_checkpoint_;
  BackgroundWriter& file_;
  RunStatistics statistics_;
};

// All of a run: until the plan's end, or the observer's. Fails as above.
Result<RunStatistics> run(SimulatedFrames& frames, const RunPlan& plan, bool has_checkpoint,
                          BackgroundWriter& file, const RunObserver& observer,
                          RunStatistics statistics);

}  // namespace ribbon
