#include "curve/crossings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "result/refusal.h"

namespace ribbon::crossings_test {

// Two strands wound round each other from left to right; the first comes back below to become the
// second. Seen on the screen the first goes down at (1, 0), the second up: over first makes it
// right-handed.
const Drawing trefoil = {{0, -1}, {2, 1}, {4, -1}, {6, 1}, {6, 4},
                         {0, 4},  {0, 1}, {2, -1}, {4, 1}, {6, -1}};

std::string problem_of(const Drawing& drawing) {
  return refusal_of(find_crossings(drawing, true));
}

void expect_problem(const Drawing& drawing, const std::string& place, const std::string& problem) {
  EXPECT_THAT(problem_of(drawing), AllOf(HasSubstr(place), HasSubstr(problem)));
}

void expect_crossing(const Crossing& crossing, double first, double second,
                     const Eigen::Vector2d& point, bool first_over, int sign) {
  EXPECT_NEAR(crossing.first, first, 1e-12);
  EXPECT_NEAR(crossing.second, second, 1e-12);
  EXPECT_NEAR((crossing.point - point).norm(), 0, 1e-12);
  EXPECT_EQ(crossing.first_over, first_over);
  EXPECT_EQ(crossing.sign, sign);
}

TEST(Crossings, trefoil_drawn_by_hand_is_right_handed_when_it_begins_over) {
  const auto crossings = find_crossings(trefoil, true);
  ASSERT_TRUE(crossings.has_value()) << crossings.error().sentence();
  ASSERT_EQ(crossings->size(), 3U);
  expect_crossing((*crossings)[0], 0.5, 6.5, {1, 0}, true, 1);
  expect_crossing((*crossings)[1], 1.5, 7.5, {3, 0}, false, 1);
  expect_crossing((*crossings)[2], 2.5, 8.5, {5, 0}, true, 1);
}

TEST(Crossings, trefoil_that_begins_under_is_left_handed) {
  const auto crossings = find_crossings(trefoil, false).value();
  ASSERT_EQ(crossings.size(), 3U);
  for (const Crossing& crossing : crossings) EXPECT_EQ(crossing.sign, -1);
  EXPECT_FALSE(crossings[0].first_over);
  EXPECT_TRUE(crossings[1].first_over);
}

TEST(Crossings, mirrored_drawing_has_the_other_sign) {
  Drawing mirrored = trefoil;
  for (auto& point : mirrored) point.x() = -point.x();
  const auto crossings = find_crossings(mirrored, true).value();
  ASSERT_EQ(crossings.size(), 3U);
  for (const Crossing& crossing : crossings) EXPECT_EQ(crossing.sign, -1);
}

TEST(Crossings, walking_backwards_keeps_the_signs_of_the_same_knot) {
  const Drawing backwards(trefoil.rbegin(), trefoil.rend());
  // The last passage of the trefoil is under, so the same knot begins under when walked backwards.
  const auto crossings = find_crossings(backwards, false).value();
  ASSERT_EQ(crossings.size(), 3U);
  for (const Crossing& crossing : crossings) EXPECT_EQ(crossing.sign, 1);
}

TEST(Crossings, figure_eight_has_two_of_each_sign) {
  const Drawing figure_eight = {{-2, 0},  {4, 0},  {4, -4}, {0, -4}, {0, 2}, {-4, 2},
                                {-4, -6}, {2, -6}, {2, 4},  {-2, 4}, {-2, 1}};
  const auto crossings = find_crossings(figure_eight, true);
  ASSERT_TRUE(crossings.has_value()) << crossings.error().sentence();
  ASSERT_EQ(crossings->size(), 4U);
  expect_crossing((*crossings)[0], 1.0 / 3, 3 + 2.0 / 3, {0, 0}, true, -1);
  expect_crossing((*crossings)[1], 2.0 / 3, 7.6, {2, 0}, false, 1);
  expect_crossing((*crossings)[2], 2.5, 7.2, {2, -4}, true, 1);
  expect_crossing((*crossings)[3], 4.5, 9 + 2.0 / 3, {-2, 2}, true, -1);
}

TEST(Crossings, curve_without_crossings_has_none) {
  EXPECT_TRUE(find_crossings({{0, 0}, {1, 0}}, true).value().empty());
  EXPECT_TRUE(find_crossings({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0.1}}, true).value().empty());
}

TEST(Crossings, sharp_corner_is_no_crossing) {
  EXPECT_TRUE(find_crossings({{0, 0}, {10, 0}, {0, 4}}, true).value().empty());
}

TEST(Crossings, crossing_at_a_vertex_of_one_strand_is_one_crossing) {
  const auto crossings = find_crossings({{0, 0}, {10, 0}, {10, 5}, {5, 0}, {0, -5}}, true).value();
  ASSERT_EQ(crossings.size(), 1U);
  expect_crossing(crossings[0], 0.5, 3, {5, 0}, true, 1);
}

TEST(Crossings, crossing_at_vertices_of_both_strands_is_one_crossing) {
  const auto crossings =
      find_crossings({{0, 1}, {5, 0}, {10, 1}, {10, 5}, {5, 0}, {4, -5}}, true).value();
  ASSERT_EQ(crossings.size(), 1U);
  expect_crossing(crossings[0], 1, 4, {5, 0}, true, 1);
}

TEST(Crossings, vertex_that_does_not_pass_to_the_other_side_touches) {
  expect_problem({{0, 0}, {10, 0}, {10, 5}, {5, 0}, {0, 5}}, "(5, 0)", "touch without crossing");
  expect_problem({{0, 1}, {5, 0}, {10, 1}, {10, 5}, {5, 0}, {4, 5}}, "(5, 0)",
                 "touch without crossing");
}

TEST(Crossings, strands_nearer_than_the_tolerance_touch) {
  expect_problem({{0, 0}, {10, 0}, {10, 5}, {5, 1e-4}, {0, 5}}, "(5, 0)", "touch");
  EXPECT_EQ(problem_of({{0, 0}, {10, 0}, {10, 5}, {5, 1e-2}, {0, 5}}), "");
}

TEST(Crossings, end_on_the_curve_touches) {
  expect_problem({{0, 0}, {10, 0}, {10, 5}, {4, 5}, {4, 0}}, "(4, 0)", "an end");
  expect_problem({{0, 0}, {10, 0}, {10, 5}, {0, 0}}, "(0, 0)", "an end");
}

TEST(Crossings, overlapping_pieces_are_refused) {
  expect_problem({{0, 0}, {10, 0}, {10, 5}, {7, 5}, {7, 0}, {3, 0}, {3, 5}}, "0)",
                 "run along each other");
}

TEST(Crossings, curve_that_folds_back_on_itself_is_refused) {
  expect_problem({{0, 0}, {10, 0}, {4, 0}, {4, 5}}, "(4, 0)", "run along each other");
}

TEST(Crossings, strands_that_cross_almost_parallel_are_refused) {
  expect_problem({{0, 0}, {100, 0}, {100, 9}, {90, 1}, {10, -1}}, "(50, 0)",
                 "run along each other");
}

TEST(Crossings, triple_point_is_refused) {
  expect_problem({{-5, 0}, {5, 0}, {5, 5}, {-5, -5}, {0, -8}, {0, 5}}, "(0, 0)", "three pieces");
}

TEST(Crossings, end_inside_a_loop_cannot_alternate) {
  expect_problem({{0, 0}, {4, 0}, {4, 3}, {-2, 3}, {-2, -2}, {2, -2}, {2, 5}}, "(2, 0)",
                 "cannot alternate");
}

TEST(Crossings, crossings_survive_points_denser_than_the_tolerance) {
  Drawing dense;
  constexpr int pieces = 20000;
  for (std::size_t i = 0; i + 1 < trefoil.size(); ++i)
    for (int k = 0; k < pieces / 9; ++k)
      dense.push_back(trefoil[i] + (trefoil[i + 1] - trefoil[i]) * (k / (pieces / 9.0)));
  const auto crossings = find_crossings(dense, true);
  ASSERT_TRUE(crossings.has_value()) << crossings.error().sentence();
  ASSERT_EQ(crossings->size(), 3U);
  EXPECT_NEAR(((*crossings)[1].point - Eigen::Vector2d(3, 0)).norm(), 0, 1e-9);
}

// 50 turns inwards and a straight way out across 49 of them. Quick, or the test is slow.
TEST(Crossings, spiral_of_20000_segments_crosses_its_way_out) {
  Drawing spiral;
  constexpr int segments = 20000;
  for (int i = 0; i < segments; ++i) {
    const double turns = 0.5 + 49.0 * i / (segments - 1);
    const double angle = 2 * std::numbers::pi * turns;
    spiral.push_back((1 - turns / 50) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  spiral.emplace_back(2, 0);
  const auto crossings = find_crossings(spiral, true);
  ASSERT_TRUE(crossings.has_value()) << crossings.error().sentence();
  ASSERT_EQ(crossings->size(), 49U);
  for (const Crossing& crossing : *crossings) EXPECT_EQ(std::abs(crossing.sign), 1);
  const double sag = std::pow(2 * std::numbers::pi * 49 / segments, 2) / 8;
  EXPECT_NEAR(crossings->front().point.x(), 0.98, sag);
}

}  // namespace ribbon::crossings_test
