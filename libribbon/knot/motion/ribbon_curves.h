// The curves of a ribbon that knot theory knows: its centre line, its two selvages, and one beside
// the centre line that is twisted round it as the selvages are.
#pragma once

#include <Eigen/Core>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// Polygons from the first end of the ribbon to the last, on its surface.
struct RibbonCurves {
  Eigen::Matrix3Xd centre_line;
  Eigen::Matrix3Xd first_selvage;
  Eigen::Matrix3Xd second_selvage;
  // Next to the centre line, an eighth of a particle's distance towards the second selvage.
  Eigen::Matrix3Xd beside_centre;
};

// The middle column of particles or, between two middle columns, the line halfway between them. It
// runs within the triangles, so it cannot meet itself unless the ribbon does.
Eigen::Matrix3Xd centre_line(const RibbonGrid& grid, const Eigen::Matrix3Xf& positions);

// In general position: each coordinate is moved by less than a quarter of the last place that
// single precision gives to the largest one, always by the same fraction of it. Recorded strands
// that do not touch lie farther apart than that, and no four vertices are left in one plane but by
// a chance that the exact tests would notice.
RibbonCurves ribbon_curves(const RibbonGrid& grid, const Eigen::Matrix3Xf& positions);

}  // namespace ribbon
