// Finds the nearest camera that sees everything.
#pragma once

#include <Eigen/Core>

#include "player/picture/picture.h"
#include "player/view/camera.h"
#include "player/view/view.h"

namespace ribbon {

// Collects points, however many, and then places the camera so near that they just fill the
// picture. Keeps four numbers only, so a whole recording can be streamed through it.
class Framing {
 public:
  Framing(const View& view, PictureSize size);

  // points: 3 x any.
  void include(const Eigen::Matrix3Xf& points);

  // Every point included is inside the picture. At least one must have been.
  [[nodiscard]] Camera camera() const;

  // How far from `target` a camera that looks at it sees every point included.
  [[nodiscard]] float distance_from(const Eigen::Vector3f& target) const;

 private:
  Camera camera_;                    // at the origin: its eye is not yet known
  Eigen::Matrix<float, 4, 3> side_;  // left, right, bottom, top: outward, in world coordinates
  Eigen::Vector4f reach_;            // how far any point reaches along each
  float nearest_;                    // along the axis towards the viewer
};

}  // namespace ribbon
