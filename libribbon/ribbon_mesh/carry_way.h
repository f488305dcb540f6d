// The ways on which hands carry parts of the band, from the drawing into the world.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// The path of that id in the drawing of the curve, in drawing units, flattened. Fails, with the
// place or without where there is no such path.
Result<std::vector<Eigen::Vector2d>> drawn_path(const CurveScene& curve, const PathId& path);

// 3 x points, m. The path consists of points.
Eigen::Matrix3Xd carry_way(const CurveScene& curve, const CarryPath& carry);

}  // namespace ribbon
