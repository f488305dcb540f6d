// Gathers the light of a picture.
#pragma once

#include <optional>

#include "player/picture/picture.h"
#include "player/picture/tone.h"
#include "player/render/cloth_colors.h"
#include "player/render/lighting.h"
#include "player/render/pixel_planes.h"
#include "player/render/quality.h"
#include "player/render/render_scene.h"
#include "player/render/sampling.h"
#include "player/view/camera.h"

namespace ribbon {

struct RenderSettings {
  Quality quality = {};
  Lighting lighting = {};
  Backdrop backdrop = {};
  ClothColors cloth = {};
  float thickness_m = 0;  // of the cloth, as it is seen at the selvages
  Tone tone = {};
  bool ground = false;  // a floor in the backdrop's colours that shows the shadows
  bool timed = false;  // asks for RenderReport::paint_s, which takes two calls of the system a tile
};

// What it took, and what the estimate of noise reached. Pixels: those of the tiles that may show
// anything but the backdrop.
struct RenderReport {
  double samples = 0;  // of a pixel, mean
  double error = 0;    // in 8-bit levels: root of the mean square over the pixels; 0 where all
                       // have as many samples
  double paint_s = 0;  // tracing and shading, of all threads together; 0 unless asked for
  double wanting = 0;  // share of the pixels whose tile is still above Quality::noise, if that is
                       // asked for
};

struct Rendered {
  LightPicture light;
  RenderReport report;
};

// Keeps what it needs from picture to picture.
class Renderer {
 public:
  explicit Renderer(RenderSettings settings);
  [[nodiscard]] const RenderSettings& settings() const { return settings_; }

  // The pixels are the same for any number of threads, and whatever was rendered before.
  Rendered render(const RenderScene& scene, const Camera& camera, PictureSize size);

 private:
  RenderSettings settings_;
  SamplePatterns patterns_;
  std::optional<PixelPlanes> planes_;  // of the last picture whose sky was smoothed
};

}  // namespace ribbon
