// Frames of a recording become picture files.
#pragma once

#include <string>
#include <vector>

#include "commandline/frame_pattern.h"
#include "playback/recording_reader.h"
#include "player/options.h"
#include "player/render/sequence_renderer.h"
#include "player/view/camera.h"
#include "result/result.h"

namespace ribbon {

// Renders `frames` (indices from 0, all readable) in their order. Returns one line
// about it. Fails when a file cannot be written or the user interrupts; what is written is
// complete.
Result<std::string> write_pictures(RecordingReader& reader, const std::vector<int>& frames,
                                   const FramePattern& pattern, const Options& options);

// Renders frames as they come, all with the camera that the first look finds.
class LivePictures {
 public:
  // Keeps references to `reader` and `options`.
  LivePictures(RecordingReader& reader, const Options& options, FramePattern pattern);

  // Renders and writes frame `index`.
  Result<void> show(int index);

 private:
  RecordingReader& reader_;
  const Options& options_;
  FramePattern pattern_;
  SequenceRenderer renderer_;
  std::vector<Camera> cameras_;  // one, once there is a frame
};

}  // namespace ribbon
