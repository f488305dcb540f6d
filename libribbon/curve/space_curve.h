// From the flat drawing to a curve in space (paper, sections 3.2 and 4.1).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "curve/crossings.h"
#include "curve/drawing.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// A curve in space: `points` are 3 x N in metres, evenly spaced by arc length.
struct SpaceCurve {
  Eigen::Matrix3Xd points;
  double length_m = 0;
  std::vector<Crossing> crossings;
};

// The uniform Catmull-Rom point at parameter t in [0, 1] between p1 and p2.
Eigen::Vector3d catmull_rom(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1,
                            const Eigen::Vector3d& p2, const Eigen::Vector3d& p3, double t);

// Reads the drawing of `scene`, finds its crossings, pulls the two passages of each apart along the
// chosen axis so that bands of `ribbon_width_m` have room, smooths with Catmull-Rom and samples
// `samples` (>= 2) points. Fails, with the place, where the drawing cannot be told or its crossings
// are too close for the width.
Result<SpaceCurve> generate_space_curve(const CurveScene& scene, double ribbon_width_m,
                                        int samples);

}  // namespace ribbon
