#include "ribbon_mesh/springs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace ribbon::springs_test {

using Pairs = std::vector<std::pair<int, int>>;

Pairs springs_of(const RibbonGrid& grid, const SpringFamily& family) {
  Pairs pairs;
  for_each_spring(grid, family, [&](int a, int b) { pairs.emplace_back(a, b); });
  return pairs;
}

TEST(Springs, join_neighbours_diagonals_and_particles_of_distance_two) {
  const SpringNetwork network = spring_network({{3, 3}, 1, 1}, {});
  const auto [along, across] = network.stretch.families;
  EXPECT_EQ(springs_of(network.grid, along),
            (Pairs{{0, 3}, {1, 4}, {2, 5}, {3, 6}, {4, 7}, {5, 8}}));
  EXPECT_EQ(springs_of(network.grid, across),
            (Pairs{{0, 1}, {1, 2}, {3, 4}, {4, 5}, {6, 7}, {7, 8}}));
  const auto [down, up] = network.shear.families;
  EXPECT_EQ(springs_of(network.grid, down), (Pairs{{0, 4}, {1, 5}, {3, 7}, {4, 8}}));
  EXPECT_EQ(springs_of(network.grid, up), (Pairs{{1, 3}, {2, 4}, {4, 6}, {5, 7}}));
  const auto [far_along, far_across] = network.bend.families;
  EXPECT_EQ(springs_of(network.grid, far_along), (Pairs{{0, 6}, {1, 7}, {2, 8}}));
  EXPECT_EQ(springs_of(network.grid, far_across), (Pairs{{0, 2}, {3, 5}, {6, 8}}));
}

TEST(Springs, of_distance_two_are_missing_in_a_ribbon_that_is_too_small_for_them) {
  for (const SpringFamily& family : spring_network({{2, 2}, 1, 1}, {}).bend.families)
    EXPECT_TRUE(springs_of({2, 2}, family).empty());
}

TEST(LimitedEdges, are_those_along_and_across_and_with_the_gate_diagonals_where_shear_resists) {
  Scene scene;
  EXPECT_EQ(limited_edges(scene), (LimitedEdges{true, true, false})) << "without any spring";
  scene.springs.shear = 1;
  EXPECT_EQ(limited_edges(scene), (LimitedEdges{true, true, true}));
  scene.contact = ContactMethod::paper;
  EXPECT_EQ(limited_edges(scene), (LimitedEdges{true, true, false}));
}

TEST(LimitedEdges, are_families_of_springs) {
  const RestSize size{{3, 3}, 0.6, 0.8};
  EXPECT_TRUE(limited_families({}, size).empty());
  ASSERT_EQ(limited_families({.across = true}, size).size(), 1U);
  EXPECT_DOUBLE_EQ(limited_families({.across = true}, size)[0].rest_length_m, 0.4);
  const auto all = limited_families({true, true, true}, size);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_DOUBLE_EQ(all[0].rest_length_m, 0.3);
  EXPECT_EQ(all[2].columns, 1);
  EXPECT_EQ(all[3].columns, -1);
}

TEST(Springs, have_the_stiffness_of_the_scene) {
  const SpringNetwork network =
      spring_network({{4, 3}, 1, 1}, {.stretch = 1, .shear = 2, .bend = 3});
  EXPECT_EQ(network.stretch.stiffness, 1);
  EXPECT_EQ(network.shear.stiffness, 2);
  EXPECT_EQ(network.bend.stiffness, 3);
}

TEST(Springs, rest_at_the_lengths_of_the_flat_band) {
  const SpringNetwork network = spring_network({{3, 3}, 0.6, 0.8}, {});
  EXPECT_DOUBLE_EQ(network.stretch.families[0].rest_length_m, 0.3);
  EXPECT_DOUBLE_EQ(network.stretch.families[1].rest_length_m, 0.4);
  EXPECT_DOUBLE_EQ(network.shear.families[0].rest_length_m, 0.5);
  EXPECT_DOUBLE_EQ(network.shear.families[1].rest_length_m, 0.5);
  EXPECT_DOUBLE_EQ(network.bend.families[0].rest_length_m, 0.6);
  EXPECT_DOUBLE_EQ(network.bend.families[1].rest_length_m, 0.8);
}

// By hand: rows 0.3 m apart, 0.8, 1.6 and 2.4 m wide, columns half and a quarter of that apart.
TEST(Springs, of_a_band_with_a_profile_rest_as_far_apart_as_its_particles_lie) {
  const RestSize tapered{{3, 3}, 0.6, 1.6, {0.8, 1.6, 2.4}};
  const SpringNetwork network = spring_network(tapered, {});
  const auto& [along, across] = network.stretch.families;
  EXPECT_DOUBLE_EQ(along.rest_m(0), 0.5);  // 0.3 along, 0.4 outwards
  EXPECT_DOUBLE_EQ(along.rest_m(1), 0.3);
  EXPECT_DOUBLE_EQ(across.rest_m(0), 0.4);
  EXPECT_DOUBLE_EQ(across.rest_m(7), 1.2);
  EXPECT_DOUBLE_EQ(network.shear.families[0].rest_m(0), 0.5);  // to the middle, 0.4 inwards
  EXPECT_DOUBLE_EQ(network.shear.families[1].rest_m(1), std::hypot(0.3, 0.8));
  EXPECT_DOUBLE_EQ(network.bend.families[0].rest_m(2), 1);
  EXPECT_DOUBLE_EQ(network.bend.families[1].rest_m(3), 1.6);
  EXPECT_DOUBLE_EQ(along.rest_length_m, 0.3) << "the shortest";
}

TEST(Springs, of_a_flat_band_with_a_profile_are_not_strained) {
  const RestSize tapered{{3, 5}, 0.6, 0.3, {0.2, 0.3, 0.4}};
  const SpringNetwork network = spring_network(tapered, {});
  for (const SpringKind* kind : network.kinds())
    for (const SpringFamily& family : kind->families)
      for_each_spring(network.grid, family, [&](int a, int b) {
        EXPECT_DOUBLE_EQ((tapered.place_m(b) - tapered.place_m(a)).norm(), family.rest_m(a));
      });
}

}  // namespace ribbon::springs_test
