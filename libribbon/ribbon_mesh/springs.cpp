#include "ribbon_mesh/springs.h"

#include "geometry/vectors.h"

namespace ribbon {

std::array<SpringFamily, 2> stretch_families(const RestSize& size) {
  return {{{1, 0, size.along_m()}, {0, 1, size.across_m()}}};
}

std::array<SpringFamily, 2> shear_families(const RestSize& size) {
  const double diagonal_m = length_of(Eigen::Vector2d(size.along_m(), size.across_m()));
  return {{{1, 1, diagonal_m}, {1, -1, diagonal_m}}};
}

SpringNetwork spring_network(const RestSize& size, const SpringScene& stiffness) {
  return {.grid = size.grid,
          .stretch = {stiffness.stretch, stretch_families(size)},
          .shear = {stiffness.shear, shear_families(size)},
          .bend = {stiffness.bend, {{{2, 0, 2 * size.along_m()}, {0, 2, 2 * size.across_m()}}}},
          .damping = stiffness.damping};
}

LimitedEdges limited_edges(const Scene& scene) {
  const bool has_shear_springs = scene.springs.shear > 0;
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

}  // namespace ribbon
