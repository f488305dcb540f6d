// Smoothed tangents of a ribbon that may be wrinkled (paper, footnote 2 and section 5.5).
#pragma once

#include <Eigen/Core>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// For each particle: the sum of the edges along its column, over as many rows to either side as the
// ribbon is particles wide, divided by the sum of their lengths. Length 1 where the ribbon is
// straight, less where it is crumpled. 3 x particles.
Eigen::Matrix3Xd smoothed_tangents(const RibbonGrid& grid, const Eigen::Matrix3Xd& positions);

}  // namespace ribbon
