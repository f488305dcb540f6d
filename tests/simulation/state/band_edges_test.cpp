#include "simulation/state/band_edges.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace ribbon::band_edges_test {

using Eigen::Matrix3Xd;
using Pairs = std::vector<std::pair<int, int>>;

// Edges of 0.5 m along and 1 m across.
constexpr NaturalSize size{RibbonGrid{2, 3}, 0.5, 2};

Pairs edges_of(const EdgeKind& kind) {
  Pairs pairs;
  for_each_edge(size.grid, kind, [&](int a, int b) { pairs.emplace_back(a, b); });
  return pairs;
}

TEST(BandEdges, are_along_across_and_both_diagonals_of_each_quad) {
  const auto [along, across] = edges_along_and_across(size);
  EXPECT_EQ(edges_of(along), (Pairs{{0, 3}, {1, 4}, {2, 5}}));
  EXPECT_EQ(edges_of(across), (Pairs{{0, 1}, {1, 2}, {3, 4}, {4, 5}}));
  const auto [down, up] = diagonals(size);
  EXPECT_EQ(edges_of(down), (Pairs{{0, 4}, {1, 5}}));
  EXPECT_EQ(edges_of(up), (Pairs{{1, 3}, {2, 4}}));
  EXPECT_EQ(along.rest_length_m, 0.5);
  EXPECT_EQ(across.rest_length_m, 1);
  EXPECT_DOUBLE_EQ(up.rest_length_m * up.rest_length_m, 1.25);
}

// By hand: row 1 lies 0.6 m instead of 0.5 from row 0; its last particle 0.7 m instead of 1 m from
// its neighbour, which shortens its one diagonal from sqrt 1.25 m to sqrt 0.85 m, by 17.5 %.
TEST(WorstStrain, is_of_those_springs_that_the_scene_has_and_of_shrinking_too) {
  Matrix3Xd x(3, 6);
  x << 0, 0, 0, 0.6, 0.6, 0.6, 0, 1, 2, 0, 1, 1.7, 0, 0, 0, 0, 0, 0;
  EXPECT_NEAR(worst_strain(size, {.stretch = 1, .shear = 1}, x), 0.3416, 1e-4);
  EXPECT_NEAR(worst_strain(size, {.shear = 1}, x), 0.1754, 1e-4);
  EXPECT_EQ(worst_strain(size, {.bend = 1}, x), 0);
}

}  // namespace ribbon::band_edges_test
