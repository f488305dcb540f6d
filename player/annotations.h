// What is drawn over the pictures of one run.
#pragma once

#include <optional>
#include <vector>

#include "player/appearance.h"
#include "player/overlay/mesh_lines.h"
#include "player/picture/caption.h"
#include "player/render/sequence_renderer.h"

namespace ribbon {

// Lets the renderer show what the ribbon is to be coloured by, if it is; `frames` as
// ValueColors::create takes them. Fails when a frame cannot be read.
Result<void> color_as_asked(const Appearance& appearance, RecordingReader& reader,
                            const std::vector<int>& frames, SequenceRenderer& renderer);

class Annotations {
 public:
  // Keeps a reference to `reader`. legend: nothing where the ribbon shows its cloth.
  Annotations(const RecordingReader& reader, const Overlays& overlays,
              std::optional<Legend> legend);

  // Lines in space, over a picture that `camera` took of `scene`, the model.
  void draw_lines_of(const RenderScene& scene, const Camera& camera, Picture& picture) const;
  // Caption and legend, over any picture of frame `index`, or of what lies `after` of the way to
  // the next: then the numbers are those of the nearer one.
  void draw_words(int index, double after, Picture& picture) const;

 private:
  [[nodiscard]] FrameNumbers numbers(int index, double after) const;
  void draw_curve(const RenderScene& scene, const Camera& camera, float width,
                  Picture& picture) const;

  const RecordingReader& reader_;
  Overlays overlays_;
  std::optional<Legend> legend_;
  // In the model; none where they are not asked for.
  SpaceLines obstacle_lines_;
  Eigen::Matrix3Xf curve_;
  float forward_m_;  // towards the eye: so a curve in the cloth is seen
  CaptionPainter painter_;
};

}  // namespace ribbon
