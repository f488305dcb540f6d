#include "ribbon_mesh/springs.h"

#include <gtest/gtest.h>

namespace ribbon::springs_test {

// By hand, for a grid of 4 x 3 particles: 3*3 + 4*2 neighbours, 2 diagonals in each of 3*2 quads,
// 2*3 + 4*1 pairs of distance two.
TEST(Springs, join_neighbours_diagonals_and_particles_of_distance_two) {
  const SpringNetwork network =
      spring_network({4, 3}, 0.6, 0.8, {.stretch = 1, .shear = 2, .bend = 3});
  EXPECT_EQ(network.stretch.springs.size(), 17U);
  EXPECT_EQ(network.shear.springs.size(), 12U);
  EXPECT_EQ(network.bend.springs.size(), 10U);
  EXPECT_EQ(network.shear.resistance, 2);
}

TEST(Springs, rest_at_the_lengths_of_the_flat_band) {
  const SpringNetwork network =
      spring_network({3, 3}, 0.6, 0.8, {.stretch = 1, .shear = 1, .bend = 1});
  EXPECT_DOUBLE_EQ(network.stretch.springs.front().rest_length_m, 0.3);
  EXPECT_DOUBLE_EQ(network.stretch.springs.back().rest_length_m, 0.4);
  for (const Spring& spring : network.shear.springs) EXPECT_DOUBLE_EQ(spring.rest_length_m, 0.5);
  EXPECT_DOUBLE_EQ(network.bend.springs.front().rest_length_m, 0.6);
  EXPECT_DOUBLE_EQ(network.bend.springs.back().rest_length_m, 0.8);
}

TEST(Springs, a_kind_without_resistance_does_not_exist) {
  const SpringNetwork network =
      spring_network({4, 3}, 0.6, 0.8, {.stretch = 1, .shear = 0, .bend = 0});
  EXPECT_TRUE(network.shear.springs.empty());
  EXPECT_TRUE(network.bend.springs.empty());
}

}  // namespace ribbon::springs_test
