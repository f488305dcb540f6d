// Where the drawn curve crosses itself (paper, section 4.1).
#pragma once

#include <vector>

#include "curve/drawing.h"
#include "result/result.h"

namespace ribbon {

// One transversal double point of the drawing, as seen by the viewer.
struct Crossing {
  double first = 0;   // where the walk meets it first: polyline parameter, segment index + fraction
  double second = 0;  // and again; first < second
  Eigen::Vector2d point;
  bool first_over = false;  // does the first passage run over the second?
  int sign = 0;             // +1 right-handed, -1 left-handed, by the usual rule of knot diagrams
                            // (drawing seen with y up, i.e. as on the screen)
};

// All crossings in order of their first passage; over and under alternate along the walk, beginning
// with `first_passage_over`. Fails with the place in drawing units when a crossing cannot be told:
// pieces that touch (are nearer than a ten-thousandth of the drawing's diagonal without crossing)
// or run along each other (cross at less than about 2 degrees), three passages through one point,
// an end shut in by a loop, so that over and under cannot alternate. `drawing` holds at least 2
// points.
Result<std::vector<Crossing>> find_crossings(const Drawing& drawing, bool first_passage_over);

}  // namespace ribbon
