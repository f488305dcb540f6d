// How large the flat band is.
#pragma once

#include <algorithm>

#include "geometry/ribbon_grid.h"

namespace ribbon {

struct RestSize {
  RibbonGrid grid;
  double length_m = 0;
  double width_m = 0;

  // Of one edge.
  [[nodiscard]] double along_m() const { return length_m / (grid.along - 1); }
  [[nodiscard]] double across_m() const { return width_m / (grid.across - 1); }
  [[nodiscard]] double shortest_edge_m() const { return std::min(along_m(), across_m()); }
};

}  // namespace ribbon
