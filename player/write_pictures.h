// Frames of a recording become pictures, and these files, a video or a stream.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "playback/recording_reader.h"
#include "player/frame_painter.h"
#include "player/options.h"
#include "player/output/open_output.h"
#include "player/view/camera_work.h"
#include "result/result.h"

namespace ribbon {

// Renders `frames` (indices from 0; lost: those of the recording, ascending, that cannot be read)
// in the order of options.order. Each is encoded and written while the next one is rendered.
// Returns one line about it. Fails when something cannot be written or the user interrupts; files
// that are there are complete.
Result<std::string> write_pictures(RecordingReader& reader, const std::vector<int>& frames,
                                   const std::vector<int>& lost, const Options& options);

// Renders frames as they come; cameras stand where the frames of the first look put them.
class LivePictures {
 public:
  // Keeps references to `reader` and `options`.
  LivePictures(RecordingReader& reader, const Options& options);

  // Comes before all else. Fails when names, cameras or colours make no sense, or
  // a preview cannot be drawn.
  Result<void> begin();
  // Renders frame `index` and has it written.
  Result<void> show(int index);
  // After the last one.
  Result<void> finish();

 private:
  RecordingReader& reader_;
  const Options& options_;
  std::vector<Shot> shots_;
  std::vector<Output> outputs_;          // of each shot
  std::optional<FramePainter> painter_;  // from begin() on
  std::optional<CameraWork> cameras_;    // once there is a frame
};

}  // namespace ribbon
