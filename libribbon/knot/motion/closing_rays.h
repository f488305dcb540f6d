// Closes the ribbon: rays from its two ends to the far, the same from frame to frame.
#pragma once

#include <Eigen/Core>
#include <array>

#include "knot/motion/ribbon_curves.h"
#include "knot/motion/view_cones.h"

namespace ribbon {

// The closure is a choice, and a different one may give a different knot. So a ray keeps its
// direction relative to its end for as long as nothing passes through it, and when something is
// about to, the ray turns out of the way beforehand, through directions in which it meets nothing.
// The rays of the centre line and of both selvages are parallel; each is kept clear of what it
// could tangle with: the centre line's of the centre line, one selvage's of the other selvage, and
// of the other end's rays.
class ClosingRays {
 public:
  // The first frame: each ray takes the clearest of 512 directions.
  void start(const RibbonCurves& curves);
  // The next frame. `before` is the last one given.
  void follow(const RibbonCurves& before, const RibbonCurves& now);

  // Unit vectors from the first and from the last end outwards.
  [[nodiscard]] const std::array<Eigen::Vector3d, 2>& directions() const { return directions_; }
  // Did an end fail to find a clear direction, now or earlier? Its ray means nothing since then.
  [[nodiscard]] const std::array<bool, 2>& buried() const { return buried_; }
  [[nodiscard]] bool any_buried() const { return buried_[0] || buried_[1]; }

 private:
  void choose(std::size_t end, const std::vector<ViewCone>& cones);
  void turn(std::size_t end, const std::vector<ViewCone>& before,
            const std::vector<ViewCone>& until_now);

  std::array<Eigen::Vector3d, 2> directions_{Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()};
  std::array<bool, 2> buried_{};
};

}  // namespace ribbon
