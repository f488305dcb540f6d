// The linking number of a ribbon's two selvages: the twist that the ribbon cannot lose.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "knot/motion/ribbon_curves.h"

namespace ribbon {

// Both selvages are closed by parallel rays to the far and joined there by a band whose half twists
// make up for every half turn of the ends, so that an end can be turned without changing the
// number, as a ribbon pulled by its free ends can. In the first frame that band has no twist as
// seen from +z (the drawing's viewer); if the ends look at him with opposite faces, it has a
// right-handed half.
class SelvageLinking {
 public:
  using Directions = std::array<Eigen::Vector3d, 2>;  // of the rays, outwards, first end first

  void start(const RibbonCurves& curves, const Directions& rays);
  // The next frame. `rays` are those that nothing passed through between `before` and `now`, and
  // that those of the frame before can be turned to without meeting anything.
  void follow(const RibbonCurves& before, const RibbonCurves& now, const Directions& rays);

  // Positive for right-handed. Empty when the selvages touched in some frame.
  [[nodiscard]] const std::optional<int>& number() const { return number_; }
  // How often an end has turned about its ray by more than a quarter of a turn from one frame to
  // the next, or gone so far that it may have. It is taken to have turned the shorter way; each
  // time that it went the longer one, the number is one off.
  [[nodiscard]] int wide_turns() const { return wide_turns_; }

 private:
  // The sum of the signs of all crossings of one selvage with the other, as seen in the frame
  // followed last.
  struct Seen {
    std::size_t view = 0;
    Directions rays;
    int crossing_sum = 0;
  };

  [[nodiscard]] std::optional<int> crossing_sum_before(const RibbonCurves& before,
                                                       const Directions& rays,
                                                       std::size_t view) const;

  std::optional<int> number_;
  std::optional<Seen> seen_;
  int wide_turns_ = 0;
};

}  // namespace ribbon
