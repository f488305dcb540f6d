// The mass-spring network of the cloth (paper, section 5.1).
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "geometry/limited_edges.h"
#include "geometry/rest_size.h"
#include "geometry/ribbon_grid.h"
#include "scene/scene.h"

namespace ribbon {

// One spring leads from each particle (i, j) of a grid to (i + rows, j + columns), where both
// exist. There are several for each particle, all alike but for their rest lengths, so that none is
// stored: the family describes them, and for_each_spring() visits them. Either rows > 0, or
// rows = 0 and columns > 0.
struct SpringFamily {
  int rows = 0;
  int columns = 0;
  double rest_length_m = 0;                 // of the shortest
  std::vector<double> rest_lengths_m = {};  // of each, by the particle that it leads from; empty:
                                            // all are as long

  // Of the spring that leads from particle a.
  [[nodiscard]] double rest_m(int a) const {
    return rest_lengths_m.empty() ? rest_length_m : rest_lengths_m[a];
  }
};

// Calls use(rest_m) where rest_m(a) is family.rest_m(a), without asking for each spring anew
// whether all are alike.
template <class Use>
decltype(auto) with_rest_lengths(const SpringFamily& family, const Use& use) {
  if (family.rest_lengths_m.empty())
    return use([alike_m = family.rest_length_m](int) { return alike_m; });
  return use([each_m = family.rest_lengths_m.data()](int a) { return each_m[a]; });
}

// Springs that resist one kind of deformation; with stiffness 0 there are none.
struct SpringKind {
  double stiffness = 0;  // N/m; the paper and the scene call it resistance
  std::array<SpringFamily, 2> families;
};

struct SpringNetwork {
  RibbonGrid grid;
  SpringKind stretch = {};  // between neighbours, along and across
  SpringKind shear = {};    // along both diagonals of each quad
  SpringKind bend = {};     // between particles of distance two, along and across
  double damping = 0;       // SpringScene::damping

  [[nodiscard]] std::array<const SpringKind*, 3> kinds() const { return {&stretch, &shear, &bend}; }
  // Does bending resist more than stretch?
  [[nodiscard]] bool bends_most() const { return bend.stiffness > stretch.stiffness; }
};

// Of a flat band: the edges along and across, and those of both diagonals.
std::array<SpringFamily, 2> stretch_families(const RestSize& size);
std::array<SpringFamily, 2> shear_families(const RestSize& size);

SpringNetwork spring_network(const RestSize& size, const SpringScene& stiffness);

// The edges whose strain is corrected in a scene, whether springs resist or not: along, across, and
// with the gate the diagonals, but these only where there are shear springs. A cloth without them
// may shear as it likes.
LimitedEdges limited_edges(const Scene& scene);

// Their families.
std::vector<SpringFamily> limited_families(const LimitedEdges& edges, const RestSize& size);

// Calls visit(a, b) with the two particles of each spring that leads from a row, by column.
template <class Visit>
void for_each_spring_of_row(const RibbonGrid& grid, const SpringFamily& family, int row,
                            const Visit& visit) {
  const int first = grid.particle(row, std::max(0, -family.columns));
  const int end = grid.particle(row, grid.across - std::max(0, family.columns));
  const int offset = grid.particle(family.rows, family.columns);
  for (int a = first; a < end; ++a) visit(a, a + offset);
}

// Likewise for all of them, row by row.
template <class Visit>
void for_each_spring(const RibbonGrid& grid, const SpringFamily& family, const Visit& visit) {
  for (int row = 0; row + family.rows < grid.along; ++row)
    for_each_spring_of_row(grid, family, row, visit);
}

// Of the springs that lead from a row, which must have some: the mean of their rest lengths.
double mean_rest_m(const RibbonGrid& grid, const SpringFamily& family, int row);

}  // namespace ribbon
