// Frames of a recording become picture files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commandline/frame_pattern.h"
#include "playback/recording_reader.h"
#include "player/annotations.h"
#include "player/options.h"
#include "player/render/sequence_renderer.h"
#include "player/view/camera_work.h"
#include "result/result.h"

namespace ribbon {

// Renders `frames` (indices from 0, all readable) in their order. Returns one line
// about it. Fails when a file cannot be written or the user interrupts; what is written is
// complete.
Result<std::string> write_pictures(RecordingReader& reader, const std::vector<int>& frames,
                                   const Options& options);

// Renders frames as they come; cameras stand where the frames of the first look put them.
class LivePictures {
 public:
  // Keeps references to `reader` and `options`.
  LivePictures(RecordingReader& reader, const Options& options);

  // Comes before all else. Fails when names, cameras or colours make no sense.
  Result<void> begin();
  // Renders and writes frame `index`.
  Result<void> show(int index);

 private:
  RecordingReader& reader_;
  const Options& options_;
  std::vector<FramePattern> patterns_;  // of each shot
  std::vector<Shot> shots_;
  SequenceRenderer renderer_;
  std::optional<Annotations> annotations_;  // from begin() on
  std::optional<CameraWork> cameras_;       // once there is a frame
};

}  // namespace ribbon
