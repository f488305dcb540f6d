// Where the drawn curve passes the object, and whether in front of it or behind it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "curve/crossings.h"
#include "curve/joined_drawing.h"
#include "curve/object_heights.h"
#include "curve/over_under.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// A piece of the walk from where it comes over the object's outline to where it leaves it.
struct ObjectRun {
  double begin = 0;  // polyline parameter, as in DoublePoint
  double end = 0;
  Eigen::Vector2d from;
  Eigen::Vector2d to;
  HeightRange object;  // its lowest and highest place on all lines of sight of the piece
};

struct ObjectPassage {
  ObjectRun run;
  bool in_front = true;  // nearer to the viewer than the object?
};

// In the order of the walk. What is narrower than a two-thousandth of the drawing may be missed.
std::vector<ObjectRun> find_object_runs(const Drawing& drawing, const ObjectHeights& object);

// Does the scene say, by letters or strokes, where the curve passes the object?
bool tells_of_object(const JoinedDrawing& drawing, const CurveScene& scene);

// As the letters F and B of the list say, or the strokes of the drawing, where all that is not
// drawn behind the object lies in front of it. None where the scene does not tell of the object.
// Fails, with the place in the scene and in the drawing, where a run has no letter, a letter or
// a stroke no run, and where an end of the curve lies before or behind the object.
Result<std::vector<ObjectPassage>> object_passages(const std::vector<DoublePoint>& points,
                                                   const JoinedDrawing& drawing,
                                                   const CurveScene& scene,
                                                   const ObjectHeights& object);

// Likewise of runs that have been found already; none: there is no object.
Result<std::vector<ObjectPassage>> object_passages(
    const std::vector<DoublePoint>& points, const JoinedDrawing& drawing, const CurveScene& scene,
    const std::optional<std::vector<ObjectRun>>& runs);

// A passage of a crossing, or one of the object, which is counted where it begins.
struct CountedPassage {
  double parameter = 0;
  std::size_t index = 0;  // among the passages of crossings, or among those of the object
  bool of_object = false;
};

// All in the order of the walk, as errors and drawings count them from 1.
std::vector<CountedPassage> counted(const std::vector<Passage>& passages,
                                    const std::vector<ObjectPassage>& objects);

// "FOUBOU", as the scene has it.
std::string letters_of(const std::vector<Crossing>& crossings,
                       const std::vector<ObjectPassage>& objects);

}  // namespace ribbon
