// Pictures of frames in the way that the user asked for: by the ray tracer, or as a preview.
#pragma once

#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "player/annotations.h"
#include "player/options.h"
#include "player/preview/preview_renderer.h"
#include "player/render/sequence_renderer.h"

namespace ribbon {

class FramePainter {
 public:
  // Keeps a reference to `reader`. frames: as ValueColors::create takes them. Fails where a preview
  // cannot be drawn, a frame cannot be read, or there is no curve to lay over it.
  static Result<FramePainter> create(RecordingReader& reader, const Options& options,
                                     const std::vector<int>& frames);

  // The height of the ground, where there is one.
  void set_lowest(float lowest_m);

  // Loads frame `index`, or what lies `after` of the way to the next (BetweenFrames). Fails when a
  // frame cannot be read.
  Result<void> show(int index, double after = 0);
  // The frame that was shown last. Fails where a preview is too large.
  Result<Picture> picture(const Camera& camera, PictureSize size);
  // As linear light, with nothing drawn over it. Fails for previews, which know none.
  Result<LightPicture> light(const Camera& camera, PictureSize size);
  // Draws over a picture that this camera took of it what is to be.
  void annotate(const Camera& camera, Picture& picture) const;

  // Of all pictures so far; nothing of previews.
  [[nodiscard]] NoiseReached noise() const;
  // Of the colours that the ribbon shows instead of its cloth.
  [[nodiscard]] std::optional<Legend> legend() const;

 private:
  using Renderer = std::variant<SequenceRenderer, PreviewRenderer>;
  FramePainter(Renderer renderer, Annotations annotations)
      : renderer_(std::move(renderer)), annotations_(std::move(annotations)) {}

  Renderer renderer_;
  Annotations annotations_;
  struct Shown {
    int index;
    double after;
    bool operator==(const Shown&) const = default;
  };
  std::optional<Shown> shown_;
};

}  // namespace ribbon
