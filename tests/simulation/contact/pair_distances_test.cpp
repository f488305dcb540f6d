#include "simulation/contact/pair_distances.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ribbon::pair_distances_test {

using Kind = FeaturePair::Kind;

constexpr RibbonGrid grid{10, 4};

// Rows 0.1 m and columns 0.2 m apart.
constexpr RestSize size{grid, 0.9, 0.6};

// The cloth is 0.3 m thick.
PairDistances thick() {
  return {size, {.min_separation_m = 0.01, .activation_m = 0.02, .thickness_m = 0.3}};
}

FeaturePair vertex_and_triangle_at_row(int row) {
  return {Kind::vertex_triangle,
          {grid.particle(0, 0), grid.particle(row, 0), grid.particle(row + 1, 0),
           grid.particle(row, 1)}};
}

TEST(PairDistances, without_thickness_are_the_same_for_all) {
  const PairDistances distances(size, {.min_separation_m = 0.01, .activation_m = 0.02});
  for (const int row : {1, 3, 8}) {
    EXPECT_EQ(distances.min_separation_m(vertex_and_triangle_at_row(row)), 0.01);
    EXPECT_EQ(distances.activation_m(vertex_and_triangle_at_row(row)), 0.02);
  }
  EXPECT_EQ(distances.largest_min_separation_m(), 0.01);
  EXPECT_EQ(distances.largest_activation_m(), 0.02);
}

TEST(PairDistances, far_parts_touch_at_the_thickness_and_give_way_to_half_of_it) {
  const FeaturePair far = vertex_and_triangle_at_row(8);  // 0.8 m away in the flat ribbon
  EXPECT_DOUBLE_EQ(thick().activation_m(far), 0.3);
  EXPECT_DOUBLE_EQ(thick().min_separation_m(far), 0.15);
  EXPECT_DOUBLE_EQ(thick().largest_activation_m(), 0.3);
  EXPECT_DOUBLE_EQ(thick().largest_min_separation_m(), 0.15);
}

TEST(PairDistances, neighbours_touch_at_half_of_their_rest_distance) {
  // By hand: four rows of 0.1 m.
  EXPECT_DOUBLE_EQ(thick().activation_m(vertex_and_triangle_at_row(4)), 0.2);
  EXPECT_DOUBLE_EQ(thick().min_separation_m(vertex_and_triangle_at_row(4)), 0.1);
  // Edges across of rows 1 and 3, columns 0-1 and 2-3: two rows and one column apart.
  const FeaturePair edges{
      Kind::edge_edge,
      {grid.particle(1, 0), grid.particle(1, 1), grid.particle(3, 2), grid.particle(3, 3)}};
  EXPECT_DOUBLE_EQ(thick().activation_m(edges), 0.5 * std::hypot(0.2, 0.2));
}

TEST(PairDistances, reach_as_far_as_each_pair_and_no_farther) {
  const PairDistances distances = thick();
  const PairReach contact = distances.activation_reach(0.01);
  const PairReach gate = distances.min_separation_reach(2);
  EXPECT_DOUBLE_EQ(contact.largest_m, 0.31);
  EXPECT_DOUBLE_EQ(gate.largest_m, 0.3);
  for (const int row : {1, 4, 8}) {
    const FeaturePair pair = vertex_and_triangle_at_row(row);
    EXPECT_EQ(contact.of_pair(pair), distances.activation_m(pair) + 0.01);
    EXPECT_EQ(gate.of_pair(pair), 2 * distances.min_separation_m(pair));
  }
  const PairDistances thin(size, {.min_separation_m = 0.01, .activation_m = 0.02});
  EXPECT_EQ(thin.activation_reach(0.01).largest_m, 0.03);
  EXPECT_FALSE(thin.activation_reach(0.01).of_pair) << "what is the same for all costs nothing";
}

TEST(PairDistances, a_corner_and_the_diagonal_beside_it_do_not_touch_in_the_flat_ribbon) {
  const FeaturePair corner{
      Kind::vertex_triangle,
      {grid.particle(1, 0), grid.particle(0, 0), grid.particle(1, 1), grid.particle(0, 1)}};
  // By hand: the corner of a 0.1 x 0.2 quad is 0.02 / sqrt 0.05 from its diagonal.
  EXPECT_NEAR(thick().activation_m(corner), 0.5 * 0.02 / std::sqrt(0.05), 1e-12);
}

// By hand: at six rows of 0.1 m half of the rest distance is the thickness.
TEST(PairDistances, of_features_up_to_twice_the_thickness_apart_go_by_that) {
  for (int row = 1; row < grid.along - 1; ++row)
    for (int column = 0; column < grid.across; ++column) {
      const FeaturePair edges{Kind::edge_edge,
                              {grid.particle(0, 0), grid.particle(0, 1), grid.particle(row, column),
                               grid.particle(row + 1, column)}};
      const double rest_m = std::hypot(0.1 * row, 0.2 * std::max(0, column - 1));
      EXPECT_NEAR(thick().activation_m(edges), std::min(0.3, 0.5 * rest_m), 1e-12)
          << row << ", " << column;
    }
}

// By hand: rows 0.1 m apart; columns 0.1 m apart in row 0, 0.3 m in row 9.
TEST(PairDistances, of_a_ribbon_with_a_profile_go_by_its_own_rows) {
  RestSize tapered{grid, 0.9, 0.6};
  for (int row = 0; row < grid.along; ++row) tapered.row_widths_m.push_back(0.3 + 0.6 * row / 9);
  const PairDistances distances(
      tapered, {.min_separation_m = 0.001, .activation_m = 0.002, .thickness_m = 1});
  const auto across = [](int row) {
    return FeaturePair{Kind::edge_edge,
                       {grid.particle(row, 0), grid.particle(row, 1), grid.particle(row, 2),
                        grid.particle(row, 3)}};
  };
  EXPECT_NEAR(distances.activation_m(across(0)), 0.05, 1e-12);
  EXPECT_NEAR(distances.activation_m(across(9)), 0.15, 1e-12);
}

TEST(PairDistances, the_obstacle_is_touched_at_half_the_thickness) {
  const int first = grid.particle_count();
  const FeaturePair with_obstacle{Kind::vertex_triangle, {0, first, first + 1, first + 2}};
  EXPECT_DOUBLE_EQ(thick().activation_m(with_obstacle), 0.15);
  EXPECT_DOUBLE_EQ(thick().min_separation_m(with_obstacle), 0.075);
}

}  // namespace ribbon::pair_distances_test
