// Renders a recording: one camera for all of it, one picture per frame.
#pragma once

#include <vector>

#include "playback/recording_reader.h"
#include "player/picture/picture.h"
#include "player/render/render_scene.h"
#include "player/render/sampling.h"
#include "player/view/framing.h"

namespace ribbon {

struct Shot {
  View view;
  PictureSize size;
};

// One camera per shot, each so near that it just holds the obstacle and the ribbon of every
// frame that can be read, so that a frame looks the same whichever others are rendered. At least
// one frame must be readable.
std::vector<Camera> frame_cameras(RecordingReader& reader, const std::vector<Shot>& shots);

class SequenceRenderer {
 public:
  // Keeps a reference to `reader`. samples: per pixel.
  SequenceRenderer(RecordingReader& reader, int samples);

  // Loads frame `index`. Fails when it cannot be read.
  Result<void> show(int index);
  // The frame that was shown last.
  [[nodiscard]] Picture picture(const Camera& camera, PictureSize size) const;

 private:
  RecordingReader& reader_;
  RenderScene scene_;
  SamplePatterns patterns_;
  Eigen::Matrix3Xf positions_;
};

}  // namespace ribbon
