// The edges of a band by their kinds: there are many for each particle, and none needs to be
// stored.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

#include "geometry/ribbon_grid.h"
#include "scene/scene.h"
#include "simulation/state/natural_size.h"

namespace ribbon {

// All edges that lead from a particle (i, j) to (i + rows, j + columns); rows >= 0.
struct EdgeKind {
  int rows = 0;
  int columns = 0;
  double rest_length_m = 0;
};

std::array<EdgeKind, 2> edges_along_and_across(const NaturalSize& size);
// Of each quad both.
std::array<EdgeKind, 2> diagonals(const NaturalSize& size);

// Calls visit(a, b) with the particles of each edge that leads from the row.
template <class Visit>
void for_each_edge_of_row(const RibbonGrid& grid, const EdgeKind& kind, int row,
                          const Visit& visit) {
  const int first = grid.particle(row, std::max(0, -kind.columns));
  const int end = grid.particle(row, grid.across - std::max(0, kind.columns));
  const int offset = grid.particle(kind.rows, kind.columns);
  for (int a = first; a < end; ++a) visit(a, a + offset);
}

// Likewise for all of them, row by row.
template <class Visit>
void for_each_edge(const RibbonGrid& grid, const EdgeKind& kind, const Visit& visit) {
  for (int row = 0; row + kind.rows < grid.along; ++row)
    for_each_edge_of_row(grid, kind, row, visit);
}

// The largest |length / rest length - 1| of the stretch and shear springs, as far as the scene has
// them; 0 without any. positions: 3 x at least all particles.
double worst_strain(const NaturalSize& size, const SpringScene& springs,
                    const Eigen::Matrix3Xd& positions);

}  // namespace ribbon
