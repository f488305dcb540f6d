// Which of two strands passes over the other (paper, section 4.1, and section 7 for knots in which
// over and under do not alternate).
#pragma once

#include <cstddef>
#include <vector>

#include "curve/crossings.h"
#include "curve/joined_drawing.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// A double point of the drawing, told which strand is nearer to the viewer.
struct Crossing {
  double first = 0;  // as DoublePoint
  double second = 0;
  Eigen::Vector2d point;
  bool first_over = false;  // does the first passage run over the second?
  int sign = 0;             // +1 right-handed, -1 left-handed, by the usual rule of knot diagrams
                            // (drawing seen with y up, i.e. as on the screen)
};

// One of the two visits of the walk to a crossing. Errors and drawings count them from 1.
struct Passage {
  double parameter = 0;      // polyline parameter
  std::size_t crossing = 0;  // index
  bool over = false;
  Eigen::Vector2d point;
};

// Over and under by turns, beginning with `first_over`. Fails, with the place, where that cannot
// be: where an end is shut in by a loop of the curve.
Result<std::vector<Crossing>> alternating(const std::vector<DoublePoint>& points, bool first_over);

// As the list says, a letter for each passage (F and B tell of the object: object_passages()).
// Fails, with the place in the scene and in the drawing, where it is too short or too long or gives
// both passages of a crossing the same letter.
Result<std::vector<Crossing>> as_listed(const std::vector<DoublePoint>& points,
                                        const CrossingList& list);

// Under at each gap of the drawing. Fails, with the place, where a gap passes under nothing or
// under more than one strand, and where strands cross without a gap, or with two.
Result<std::vector<Crossing>> as_gaps_say(const std::vector<DoublePoint>& points,
                                          const JoinedDrawing& drawing);

// As drawing and scene want it: by gaps or, where strokes tell of the object, by these; by the list
// (not by both: that fails); else alternating.
Result<std::vector<Crossing>> over_and_under(const std::vector<DoublePoint>& points,
                                             const JoinedDrawing& drawing, const CurveScene& scene);

// In the order of the walk, two of each crossing.
std::vector<Passage> passages_along(const std::vector<Crossing>& crossings);

}  // namespace ribbon
