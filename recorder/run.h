// The run itself: frame after frame into a recording.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "recorder/run_statistics.h"
#include "recorder/simulated_frames.h"
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

// Where the user wants a run to end, whatever the scene says; at most one of the two.
struct RunLimit {
  std::optional<double> until_s = std::nullopt;  // simulated time, > 0
  std::optional<int> frames = std::nullopt;      // of the whole recording, at least 2

  [[nodiscard]] bool is_set() const { return until_s || frames; }
};

// A recording to begin.
struct NewRecording {
  std::filesystem::path file;
  std::string program;                     // that writes it, and version
  std::vector<std::string> settings = {};  // of the scene that were changed: "fastening.speed=0.3"
  Overwrite overwrite = Overwrite::no;     // of an older file
};

// Fails where it would take the place of an older file and may not. To be asked before the long
// work that comes first; the writer asks again.
Result<void> check_place(const NewRecording& recording);

// One a line, as recordings hold them.
std::string settings_text(const std::vector<std::string>& settings);

struct RunPlan {
  int frames = 0;             // how many the recording is to hold in the end
  bool is_cut_short = false;  // are these fewer than the scene wants?
  bool until_tight = false;
  double checkpoint_every_s = 0;  // 0: at the first frame and at the end alone
};

// A scene that lasts until the limit, if that is beyond its duration. The limit must be set.
Result<Scene> extended(const Scene& scene, const RunLimit& limit);

// What to do for a scene (with an extended one, of that).
RunPlan plan_of(const Scene& scene, const RunLimit& limit);

// What has ended a run that has got to where `frames` stands; unknown: nothing yet.
RunEnding ending_at(SimulatedFrames& frames, const RunPlan& plan);

// Records frames until the plan's end, or the observer's, with a checkpoint at each multiple of the
// plan's interval, one with the first frame of all and one with the last, and finishes the file.
// has_checkpoint: is there one of the frame at which `frames` stands? Adds to `statistics`, which
// know what there was before. Fails where the file does, and where a ribbon that is recorded
// without loss gets out of the reach in which its gap is guaranteed.
Result<RunStatistics> run(SimulatedFrames& frames, const RunPlan& plan, bool has_checkpoint,
                          BackgroundWriter& file, const RunObserver& observer,
                          RunStatistics statistics);

}  // namespace ribbon
