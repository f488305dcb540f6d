// The mass-spring network of the cloth (paper, section 5.1).
#pragma once

#include <vector>

#include "geometry/ribbon_grid.h"
#include "scene/scene.h"

namespace ribbon {

struct Spring {
  int a = 0;  // particle indices
  int b = 0;
  double rest_length_m = 0;
};

// Springs of one kind share one resistance. A kind whose resistance is 0 has no springs.
struct SpringSet {
  double resistance = 0;  // N/m
  std::vector<Spring> springs;
};

struct SpringNetwork {
  SpringSet stretch;  // between neighbours, along and across
  SpringSet shear;    // along both diagonals of each quad
  SpringSet bend;     // between particles of distance two, along and across
};

// Springs of a flat band of the given size: what the scene asks for and no more.
SpringNetwork spring_network(const RibbonGrid& grid, double length_m, double width_m,
                             const SpringScene& resistances);

}  // namespace ribbon
