// Lines in space, drawn over a picture of the scene that they are in.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "player/picture/picture.h"
#include "player/render/render_scene.h"
#include "player/view/camera.h"

namespace ribbon {

struct SpaceLines {
  Eigen::Matrix3Xf points;                // 3 x any, metres
  std::vector<std::array<int, 2>> lines;  // which points they join
};

// Through all points, one after the other.
SpaceLines polyline(Eigen::Matrix3Xf points);

struct LineStyle {
  Color ink;
  float width = 1;  // pixels
  float opacity = 1;
  float hidden_opacity = 0;  // of what the ribbon or the obstacle hides
};

// Draws lines into a picture that `camera` took of `scene`. Lines that lie in a surface are seen on
// it. The same for any number of threads.
void draw_lines(const SpaceLines& lines, const LineStyle& style, const RenderScene& scene,
                const Camera& camera, Picture& picture);

}  // namespace ribbon
