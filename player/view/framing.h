// Finds the nearest camera that sees everything.
#pragma once

#include <Eigen/Core>

#include "player/picture/picture.h"
#include "player/view/camera.h"

namespace ribbon {

// From where the scene is looked at, in degrees. The obstacle's axis is y; the knot lies at +z.
struct View {
  float azimuth_deg = 0;    // 0 from the front (+z), 90 from +x
  float elevation_deg = 0;  // 0 level, 90 straight down
};

inline constexpr View three_quarter_view{36, 22};
inline constexpr View top_view{0, 62};

// Collects points, however many, and then places the camera so near that they just fill the
// picture. Keeps four numbers only, so a whole recording can be streamed through it.
class Framing {
 public:
  Framing(const View& view, PictureSize size);

  // points: 3 x any.
  void include(const Eigen::Matrix3Xf& points);

  // Every point included is inside the picture. At least one must have been.
  [[nodiscard]] Camera camera() const;

 private:
  Camera camera_;                    // its eye is not yet known
  Eigen::Matrix<float, 4, 3> side_;  // left, right, bottom, top: outward, in world coordinates
  Eigen::Vector4f reach_;            // how far any point reaches along each
  float nearest_;                    // along the axis towards the viewer
};

}  // namespace ribbon
