// Renders the frames of a recording.
#pragma once

#include "playback/recording_reader.h"
#include "player/picture/picture.h"
#include "player/render/render_scene.h"
#include "player/render/sampling.h"
#include "player/view/camera.h"

namespace ribbon {

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
