// Renders the frames of a recording.
#pragma once

#include "playback/recording_reader.h"
#include "player/picture/picture.h"
#include "player/render/render.h"
#include "player/render/render_scene.h"
#include "player/view/camera.h"

namespace ribbon {

class SequenceRenderer {
 public:
  // Keeps a reference to `reader`.
  SequenceRenderer(RecordingReader& reader, RenderSettings settings);

  // Loads frame `index`. Fails when it cannot be read.
  Result<void> show(int index);
  // The frame that was shown last.
  Picture picture(const Camera& camera, PictureSize size);

 private:
  RecordingReader& reader_;
  RenderScene scene_;
  Renderer renderer_;
  Eigen::Matrix3Xf positions_;
};

}  // namespace ribbon
