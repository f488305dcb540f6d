// The drawing as a smooth plan, by centripetal Catmull-Rom curves (paper, section 4.1).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "curve/over_under.h"

namespace ribbon {

// What the smooth curve passes through: the drawing's own points and its passages.
struct Controls {
  Drawing points;
  std::vector<std::size_t> passages;  // their indices in `points`
};

Controls controls_of(const Drawing& drawing, const std::vector<Passage>& passages);

// The smoothed plan as chords, and where in it the passages are.
struct Plan {
  Drawing points;
  std::vector<std::size_t> passages;
  std::vector<double> lengths = {};  // along it, up to each point; of a fine plan alone
};

// Enough to find crossings.
Plan coarse_plan(const Controls& controls);

// Fine enough to measure lengths, both in the plan and along the rises of `rise`.
Plan fine_plan(const Controls& controls, double rise);

}  // namespace ribbon
