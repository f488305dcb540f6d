// Renders what the outputs of several cameras want.
#pragma once

#include <optional>
#include <vector>

#include "commandline/progress.h"
#include "player/frame_painter.h"
#include "player/interpolation_check.h"
#include "player/options.h"
#include "player/output/open_output.h"
#include "player/view/camera_work.h"
#include "result/result.h"

namespace ribbon {

// The frame that `painter` shows, as this format stores it: linear light has nothing drawn over it.
// Fails as the painter does.
Result<OutputPicture> rendered(FramePainter& painter, const Camera& camera, PictureSize size,
                               PictureFormat format, const PlayedFrame& frame);

class FilmRenderer {
 public:
  // Keeps references to all but the shots, of which each has its output.
  FilmRenderer(RecordingReader& reader, const Options& options, std::vector<Shot> shots,
               std::vector<Output>& outputs);

  // Comes before all else. asked: the frames that the user asked for, by which colours are chosen;
  // whichever of them this machine renders. Fails when one cannot be read, or a preview cannot be
  // drawn.
  Result<void> prepare(const std::vector<int>& asked);

  // Hands the pictures of this frame to those outputs that want them. Frames come in the order of
  // the film. Fails when the frame cannot be read, or a picture before could not be written.
  Result<void> render(const PlayedFrame& frame);

  // No more frames come: what is told on standard error stands alone.
  void end() { progress_.end(); }

  // How many pictures have been rendered.
  [[nodiscard]] int done() const { return done_; }
  // Of what was rendered.
  [[nodiscard]] const Interpolated& interpolated() const { return interpolated_; }
  [[nodiscard]] NoiseReached noise() const { return painter_->noise(); }

 private:
  Result<void> show(const PlayedFrame& frame);
  bool is_wanted(std::size_t shot, const PlayedFrame& frame);

  RecordingReader& reader_;
  const Options& options_;
  std::vector<Output>& outputs_;
  CameraWork cameras_;
  std::optional<FramePainter> painter_;  // from prepare() on
  std::vector<std::size_t> next_;        // of each output's frames
  ProgressLine progress_;
  int done_ = 0;
  InterpolationCheck check_;
  Interpolated interpolated_;
};

}  // namespace ribbon
