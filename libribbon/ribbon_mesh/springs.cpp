#include "ribbon_mesh/springs.h"

#include <cmath>

namespace ribbon {

namespace {

// Joins every particle (i, j) with (i + rows, j + columns) where both exist.
void join(const RibbonGrid& grid, int rows, int columns, double rest_length_m, SpringSet& set) {
  for (int i = 0; i + rows < grid.along; ++i) {
    for (int j = 0; j < grid.across; ++j) {
      if (j + columns < 0 || j + columns >= grid.across) continue;
      set.springs.push_back(
          {grid.particle(i, j), grid.particle(i + rows, j + columns), rest_length_m});
    }
  }
}

}  // namespace

SpringNetwork spring_network(const RibbonGrid& grid, double length_m, double width_m,
                             const SpringScene& resistances) {
  const double along_m = length_m / (grid.along - 1);
  const double across_m = width_m / (grid.across - 1);
  const double diagonal_m = std::hypot(along_m, across_m);
  SpringNetwork network;
  network.stretch.resistance = resistances.stretch;
  network.shear.resistance = resistances.shear;
  network.bend.resistance = resistances.bend;
  for (SpringSet* set : {&network.stretch, &network.shear, &network.bend})
    if (set->resistance > 0)
      set->springs.reserve(2 * static_cast<std::size_t>(grid.particle_count()));
  if (resistances.stretch > 0) {
    join(grid, 1, 0, along_m, network.stretch);
    join(grid, 0, 1, across_m, network.stretch);
  }
  if (resistances.shear > 0) {
    join(grid, 1, 1, diagonal_m, network.shear);
    join(grid, 1, -1, diagonal_m, network.shear);
  }
  if (resistances.bend > 0) {
    join(grid, 2, 0, 2 * along_m, network.bend);
    join(grid, 0, 2, 2 * across_m, network.bend);
  }
  return network;
}

}  // namespace ribbon
