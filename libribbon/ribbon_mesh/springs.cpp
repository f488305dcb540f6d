#include "ribbon_mesh/springs.h"

#include <cmath>
#include <limits>

#include "geometry/vectors.h"

namespace ribbon {

namespace {

// alike_m: the rest length of each spring in a band without a width profile.
SpringFamily family_of(const RestSize& size, int rows, int columns, double alike_m) {
  SpringFamily family{rows, columns, alike_m};
  if (!size.has_profile()) return family;
  family.rest_lengths_m.assign(size.grid.particle_count(), alike_m);
  double shortest_m = std::numeric_limits<double>::infinity();
  for_each_spring(size.grid, family, [&](int a, int b) {
    family.rest_lengths_m[a] = length_of(size.place_m(b) - size.place_m(a));
    shortest_m = std::min(shortest_m, family.rest_lengths_m[a]);
  });
  if (std::isfinite(shortest_m)) family.rest_length_m = shortest_m;
  return family;
}

}  // namespace

std::array<SpringFamily, 2> stretch_families(const RestSize& size) {
  return {{family_of(size, 1, 0, size.along_m()), family_of(size, 0, 1, size.across_m())}};
}

std::array<SpringFamily, 2> shear_families(const RestSize& size) {
  const double diagonal_m = length_of(Eigen::Vector2d(size.along_m(), size.across_m()));
  return {{family_of(size, 1, 1, diagonal_m), family_of(size, 1, -1, diagonal_m)}};
}

SpringNetwork spring_network(const RestSize& size, const SpringScene& stiffness) {
  return {.grid = size.grid,
          .stretch = {stiffness.stretch, stretch_families(size)},
          .shear = {stiffness.shear, shear_families(size)},
          .bend = {stiffness.bend,
                   {{family_of(size, 2, 0, 2 * size.along_m()),
                     family_of(size, 0, 2, 2 * size.across_m())}}},
          .damping = stiffness.damping};
}

LimitedEdges limited_edges(const Scene& scene) {
  const bool has_shear_springs =
      scene.springs.shear > 0 || (scene.cloth && scene.cloth->tells_shear);
  return {.along = true,
          .across = true,
          .diagonals = scene.contact == ContactMethod::gate && has_shear_springs};
}

std::vector<SpringFamily> limited_families(const LimitedEdges& edges, const RestSize& size) {
  const auto [along, across] = stretch_families(size);
  const auto diagonals = shear_families(size);
  std::vector<SpringFamily> families;
  if (edges.along) families.push_back(along);
  if (edges.across) families.push_back(across);
  if (edges.diagonals) families.insert(families.end(), diagonals.begin(), diagonals.end());
  return families;
}

double mean_rest_m(const RibbonGrid& grid, const SpringFamily& family, int row) {
  double sum_m = 0;
  int count = 0;
  for_each_spring_of_row(grid, family, row, [&](int a, int) {
    sum_m += family.rest_m(a);
    ++count;
  });
  return sum_m / count;
}

}  // namespace ribbon
