// A centre line with width: the particles of the ribbon at the start (paper, section 4.2, Figure
// 4).
#pragma once

#include <Eigen/Core>

#include "curve/space_curve.h"
#include "geometry/ribbon_grid.h"
#include "scene/scene.h"

namespace ribbon {

struct RibbonMesh {
  RibbonGrid grid;
  Eigen::Matrix3Xd positions;  // 3 x particles, metres
  Eigen::Matrix2Xf uv;         // 2 x particles: u along, v across, both from 0 to 1
  double length_m = 0;         // of the flat band
  double width_m = 0;
};

// Puts `ribbon.across` particles on the width line of each of the curve's points. The curve must
// have been sampled with `ribbon.along` points; axis: the one its crossings were pulled apart
// along.
RibbonMesh generate_ribbon_mesh(const SpaceCurve& curve, const RibbonScene& ribbon, Axis axis);

}  // namespace ribbon
