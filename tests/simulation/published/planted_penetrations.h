// Small ribbons with penetrations planted by hand.
#pragma once

#include <Eigen/Core>

#include "geometry/flat_ribbon.h"
#include "geometry/ribbon_grid.h"
#include "simulation/detection/bodies.h"
#include "simulation/published/penetration.h"

namespace ribbon {

// A ribbon folded like a U lying on its side: the second half returns at height `distance` over the
// first.
inline Eigen::Matrix3Xd folded_ribbon(const RibbonGrid& grid, double distance) {
  Eigen::Matrix3Xd positions = flat_ribbon(grid);
  const int middle = grid.along / 2;
  for (int p = 0; p < grid.particle_count(); ++p)
    if (grid.row(p) >= middle)
      positions.col(p) << 2 * middle - grid.row(p) - 0.5, distance, grid.column(p) + 0.3;
  return positions;
}

// The folded ribbon with nothing else about.
struct Folded {
  RibbonGrid grid;
  Eigen::Matrix3Xd positions;
  Bodies bodies;
};

inline Folded folded(double distance, const RibbonGrid& grid = {21, 5}) {
  return {grid, folded_ribbon(grid, distance), {grid, std::nullopt}};
}

inline Bodies ribbon_alone(const RibbonGrid& grid) {
  return {grid, std::nullopt};
}

// The flat ribbon with a large floor at height y under or over it; the floor's outside is up.
struct OverFloor {
  Eigen::Matrix3Xd positions;
  Bodies bodies;
};
inline OverFloor ribbon_over_floor(const RibbonGrid& grid, double floor_y) {
  Eigen::Matrix3Xd corners(3, 4);
  corners << -50, 50, 50, -50,             //
      floor_y, floor_y, floor_y, floor_y,  //
      50, 50, -50, -50;
  Eigen::Matrix3Xi floor(3, 2);
  floor << 0, 0, 1, 2, 2, 3;
  return {flat_ribbon(grid), Bodies{grid, ObstacleBody(floor, corners)}};
}

}  // namespace ribbon
