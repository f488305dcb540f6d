// Draws frames of a recording as fast as they are replayed.
#pragma once

#include <memory>

#include "playback/recording_reader.h"
#include "player/picture/picture.h"
#include "player/preview/preview_settings.h"
#include "player/view/camera.h"
#include "result/result.h"

namespace ribbon {

// The ribbon with its cloth, without shadows, the obstacle as a wireframe, the curve that was drawn
// highlighted (paper, Figure 1). The pixels are the same for any number of threads.
class PreviewRenderer {
 public:
  // Keeps a reference to `reader`. Fails where there is no OpenGL.
  static Result<PreviewRenderer> create(RecordingReader& reader, const PreviewSettings& settings);

  PreviewRenderer(PreviewRenderer&&) noexcept;
  PreviewRenderer& operator=(PreviewRenderer&&) noexcept;
  ~PreviewRenderer();

  // Loads frame `index`, or what lies `after` of the way to the next (BetweenFrames). Fails when a
  // frame cannot be read.
  Result<void> show(int index, double after = 0);
  // The frame that was shown last, by a camera about its model. Fails when there is not enough
  // memory.
  Result<Picture> picture(const Camera& camera, PictureSize size);

 private:
  struct State;
  explicit PreviewRenderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace ribbon
