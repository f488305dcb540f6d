// Where the drawn curve crosses itself (paper, section 4.1).
#pragma once

#include <vector>

#include "curve/drawing.h"
#include "result/result.h"

namespace ribbon {

// One transversal double point of the drawing, as seen by the viewer.
struct DoublePoint {
  double first = 0;   // where the walk meets it first: polyline parameter, segment index + fraction
  double second = 0;  // and again; first < second
  Eigen::Vector2d point;
  int sign_if_first_is_over = 0;  // of the crossing: +1 right-handed, -1 left-handed
};

// All double points in order of their first passage. Fails with the place in drawing units when one
// cannot be told: pieces that touch (are nearer than a ten-thousandth of the drawing's diagonal
// without crossing) or run along each other (cross at less than about 2 degrees), three passages
// through one point. `drawing` holds at least 2 points.
Result<std::vector<DoublePoint>> find_double_points(const Drawing& drawing);

}  // namespace ribbon
