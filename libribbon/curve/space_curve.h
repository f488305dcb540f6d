// From the flat drawing to a curve in space (paper, sections 3.2 and 4.1).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "curve/object_heights.h"
#include "curve/object_passages.h"
#include "curve/over_under.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// A curve in space: `points` are 3 x N in metres, evenly spaced by arc length.
struct SpaceCurve {
  Eigen::Matrix3Xd points;
  double length_m = 0;
  std::vector<Crossing> crossings;
  std::vector<ObjectPassage> objects = {};
  std::vector<double> passage_shares = {};  // of its length, where passages_along(crossings) are
  std::optional<Error> squeezed = std::nullopt;  // what TightPassage::refuse would have said
};

// What to do where passages follow one another so closely that, however high each of them runs, the
// curve would rise more steeply than 45 degrees if they were the ribbon's width and the clearance
// apart.
enum class TightPassage {
  refuse,
  squeeze,  // pull all passages apart only as far as the tightest ones allow: narrower bands fit
};

// Reads the drawing of `scene`, finds its crossings, pulls the two passages of each apart along the
// chosen axis so that bands as wide as `ribbon` there, standing along that axis, have room, smooths
// with Catmull-Rom and samples as many points (>= 2) as the ribbon has rows. The curve is level at
// each passage and lies in the plane at its ends. Passages are half of both strands' mean width +
// clearance above or below the plane (from the object as far as the widest row needs); where that
// would be too steep, or where the drawing tells of the object, as high as passage_heights() finds
// room for. Fails, with the place, where the drawing cannot be told, where smoothing would make it
// cross elsewhere, and where a passage is too tight and not to be squeezed or the object too high
// to be passed. object: empty where there is none.
Result<SpaceCurve> generate_space_curve(const CurveScene& scene, const RibbonScene& ribbon,
                                        TightPassage tight_passage = TightPassage::refuse,
                                        const ObjectHeights& object = {});

}  // namespace ribbon
