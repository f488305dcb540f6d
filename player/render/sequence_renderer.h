// Renders the frames of a recording.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "playback/between_frames.h"
#include "playback/recording_reader.h"
#include "player/measure/particle_measure.h"
#include "player/measure/value_colors.h"
#include "player/picture/picture.h"
#include "player/render/render.h"
#include "player/render/render_scene.h"
#include "player/view/camera.h"

namespace ribbon {

// What the estimates of noise came to, in the worst of some pictures.
struct NoiseReached {
  double error = 0;    // RenderReport::error
  double wanting = 0;  // RenderReport::wanting
};

class SequenceRenderer {
 public:
  // Keeps a reference to `reader`.
  SequenceRenderer(RecordingReader& reader, RenderSettings settings);

  // From the next frame on the ribbon shows measured values instead of its cloth; `colors` must use
  // the same reader.
  void color_by(ValueColors colors) { colors_.emplace(std::move(colors)); }

  // Where the ground lies in the model, if there is to be one: below everything in any frame.
  void set_lowest(float height_m);

  // Loads frame `index`, or what lies `after` of the way to the next (BetweenFrames): measured
  // values are then those of the nearer one. Fails when a frame cannot be read.
  Result<void> show(int index, double after = 0);
  // The frame that was shown last, by a camera about its model: as linear light, and as it is
  // shown on a screen.
  LightPicture light(const Camera& camera, PictureSize size);
  Picture picture(const Camera& camera, PictureSize size);

  // Of all pictures so far.
  [[nodiscard]] const NoiseReached& noise() const { return noise_; }

  // The model.
  [[nodiscard]] const RenderScene& scene() const { return scene_; }
  // Of the colours that the ribbon shows instead of its cloth.
  [[nodiscard]] std::optional<Legend> legend() const;

 private:
  void set_ribbon(int index);
  std::vector<float> half_thickness(int index);
  Result<void> color(int index, double after);

  RecordingReader& reader_;
  BetweenFrames between_;
  float scale_;  // of the model
  RenderScene scene_;
  Renderer renderer_;
  NoiseReached noise_;
  std::optional<ValueColors> colors_;
  std::optional<ParticleMeasure> gaps_;  // where the cloth is to be seen to be thick
  std::optional<int> tree_frame_;        // where the tree was built that the scene has
  Eigen::Matrix3Xf tree_positions_;
  Eigen::Matrix3Xf positions_;
  Eigen::Matrix3Xf measured_;  // of the nearer frame, where positions_ lie between two
};

}  // namespace ribbon
