// How the smoothed plan is lifted: where along the walk the curve is level, and how high.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "curve/heights.h"
#include "curve/object_passages.h"
#include "curve/smooth_plan.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// What the walk meets, as the drawing has it.
struct WalkedPassages {
  std::vector<Passage> crossings;      // in the order of the walk
  std::vector<ObjectPassage> objects;  // likewise
};

// A place where the curve is level: a passage, the begin or the end of one of the object.
struct WalkStop {
  double length = 0;  // along the plan
  Eigen::Vector2d point;
  std::string name;  // "passage 3", "the begin of passage 4"
  // Of the begin or the end of a run before or behind the object: which one, and how far from the
  // outline.
  std::optional<std::size_t> run = std::nullopt;
  double from_outline = 0;
};

// The stops are the passages of the profile.
struct StoppedWalk {
  std::vector<WalkStop> stops;  // in the order of the walk
  WalkProfile profile;
  double margin = 0;  // as far as a run wants to be level beside the outline
};

// Lengths in drawing units. A run before or behind the object is level with it from `margin` before
// to `margin` behind its outline, as far as there is room, and `clearance` farther off than its
// crossings need. Fails, with the place, where the plan passes the object otherwise than the
// drawing.
Result<StoppedWalk> stopped_walk(const Plan& plan, const WalkedPassages& passages,
                                 const ObjectHeights& object, double margin, double clearance);

// What is to be said where the ribbon has no room.
tl::unexpected<Error> too_tight(const CurveScene& scene, const RibbonScene& ribbon,
                                const StoppedWalk& walk, const TightCircle& tight);

// The plan with heights: of the stops, and 0 towards both ends.
std::vector<Eigen::Vector3d> raised(const Plan& plan, const std::vector<WalkStop>& stops,
                                    const std::vector<double>& heights);

}  // namespace ribbon
