// Does anything pass through anything while all points move straight from one frame to the next?
#pragma once

#include <Eigen/Core>

namespace ribbon {

// A polygon in two frames, 3 x the same at least 2 vertices, metres.
struct MovingCurve {
  const Eigen::Matrix3Xd& before;
  const Eigen::Matrix3Xd& now;
};

// True proves it: at no instant do edges meet that have no vertex in common. (Two that have one may
// fold onto each other; nothing passes through anything by that.) False: some do, or come so near
// that rounding leaves it open.
bool stays_clear_of_itself(const MovingCurve& curve);
bool stay_clear(const MovingCurve& one, const MovingCurve& other);

}  // namespace ribbon
