// From the flat drawing to a curve in space (paper, sections 3.2 and 4.1).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "curve/over_under.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// A curve in space: `points` are 3 x N in metres, evenly spaced by arc length.
struct SpaceCurve {
  Eigen::Matrix3Xd points;
  double length_m = 0;
  std::vector<Crossing> crossings;
  std::optional<Error> squeezed = std::nullopt;  // what TightPassage::refuse would have said
};

// The centripetal Catmull-Rom point at parameter t in [0, 1] between p1 and p2: the usual one where
// the points are evenly spaced, without loops or overshoot where they are not. Consecutive points
// must differ.
Eigen::Vector3d catmull_rom(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1,
                            const Eigen::Vector3d& p2, const Eigen::Vector3d& p3, double t);

// What to do where passages follow one another so closely that, however high each of them runs, the
// curve would rise more steeply than 45 degrees if they were the ribbon's width and the clearance
// apart.
enum class TightPassage {
  refuse,
  squeeze,  // pull all passages apart only as far as the tightest ones allow: narrower bands fit
};

// Reads the drawing of `scene`, finds its crossings, pulls the two passages of each apart along the
// chosen axis so that bands of `ribbon_width_m` standing along that axis have room, smooths with
// Catmull-Rom and samples `samples` (>= 2) points. The curve is level at each passage and lies in
// the plane at its ends. Passages are half of width + clearance above or below the plane; where
// that would be too steep, as high as passage_heights() finds room for. Fails, with the place,
// where the drawing cannot be told, where smoothing would make it cross elsewhere, and where a
// passage is too tight and not to be squeezed.
Result<SpaceCurve> generate_space_curve(const CurveScene& scene, double ribbon_width_m, int samples,
                                        TightPassage tight_passage = TightPassage::refuse);

}  // namespace ribbon
