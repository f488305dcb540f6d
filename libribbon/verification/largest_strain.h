// How far is the cloth stretched?
#pragma once

#include <Eigen/Core>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// The spring whose length differs most from its rest length.
struct LargestStrain {
  double strain = 0;  // |length / rest length - 1|
  int first = 0;      // the particles that it joins
  int second = 0;
};

// Of a ribbon that is at rest length_m x width_m: neighbours along and across (stretch) and both
// diagonals of each quad (shear). positions: 3 x particles.
LargestStrain largest_strain(const RibbonGrid& grid, double length_m, double width_m,
                             const Eigen::Matrix3Xf& positions);

}  // namespace ribbon
