// A ribbon at rest.
#pragma once

#include <Eigen/Core>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// In the plane y = 0, rows 1 m apart along x, columns 1 m apart along z.
inline Eigen::Matrix3Xd flat_ribbon(const RibbonGrid& grid) {
  Eigen::Matrix3Xd positions(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p)
    positions.col(p) << grid.row(p), 0, grid.column(p);
  return positions;
}

}  // namespace ribbon
