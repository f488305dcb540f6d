// Where the vertices may be until the next detection.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/box.h"

namespace ribbon {

// For each vertex its straight way from t0 to t1 (3 x vertices each).
std::vector<MovingBox> vertex_ranges(const Eigen::Matrix3Xd& t0, const Eigen::Matrix3Xd& t1);

}  // namespace ribbon
