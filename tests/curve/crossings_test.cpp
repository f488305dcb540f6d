#include "curve/crossings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "curve/over_under.h"
#include "curve/trefoil_drawing.h"
#include "result/refusal.h"

namespace ribbon::crossings_test {

Result<std::vector<Crossing>> crossings_of(const Drawing& drawing, bool first_over) {
  return find_double_points(drawing).and_then(
      [&](const std::vector<DoublePoint>& points) { return alternating(points, first_over); });
}

std::string problem_of(const Drawing& drawing) {
  return refusal_of(crossings_of(drawing, true));
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
  const auto crossings = crossings_of(trefoil_drawing, true);
  ASSERT_TRUE(crossings.has_value()) << crossings.error().sentence();
  ASSERT_EQ(crossings->size(), 3U);
  expect_crossing((*crossings)[0], 0.5, 6.5, {1, 0}, true, 1);
  expect_crossing((*crossings)[1], 1.5, 7.5, {3, 0}, false, 1);
  expect_crossing((*crossings)[2], 2.5, 8.5, {5, 0}, true, 1);
}

TEST(Crossings, trefoil_that_begins_under_is_left_handed) {
  const auto crossings = crossings_of(trefoil_drawing, false).value();
  ASSERT_EQ(crossings.size(), 3U);
  for (const Crossing& crossing : crossings) EXPECT_EQ(crossing.sign, -1);
  EXPECT_FALSE(crossings[0].first_over);
  EXPECT_TRUE(crossings[1].first_over);
}

TEST(Crossings, mirrored_drawing_has_the_other_sign) {
  Drawing mirrored = trefoil_drawing;
  for (auto& point : mirrored) point.x() = -point.x();
  const auto crossings = crossings_of(mirrored, true).value();
  ASSERT_EQ(crossings.size(), 3U);
  for (const Crossing& crossing : crossings) EXPECT_EQ(crossing.sign, -1);
}

TEST(Crossings, walking_backwards_keeps_the_signs_of_the_same_knot) {
  const Drawing backwards(trefoil_drawing.rbegin(), trefoil_drawing.rend());
  // The last passage of the trefoil is under, so the same knot begins under when walked backwards.
  const auto crossings = crossings_of(backwards, false).value();
  ASSERT_EQ(crossings.size(), 3U);
  for (const Crossing& crossing : crossings) EXPECT_EQ(crossing.sign, 1);
}

TEST(Crossings, figure_eight_has_two_of_each_sign) {
  const Drawing figure_eight = {{-2, 0},  {4, 0},  {4, -4}, {0, -4}, {0, 2}, {-4, 2},
                                {-4, -6}, {2, -6}, {2, 4},  {-2, 4}, {-2, 1}};
  const auto crossings = crossings_of(figure_eight, true);
  ASSERT_TRUE(crossings.has_value()) << crossings.error().sentence();
  ASSERT_EQ(crossings->size(), 4U);
  expect_crossing((*crossings)[0], 1.0 / 3, 3 + 2.0 / 3, {0, 0}, true, -1);
  expect_crossing((*crossings)[1], 2.0 / 3, 7.6, {2, 0}, false, 1);
  expect_crossing((*crossings)[2], 2.5, 7.2, {2, -4}, true, 1);
  expect_crossing((*crossings)[3], 4.5, 9 + 2.0 / 3, {-2, 2}, true, -1);
}

TEST(Crossings, curve_without_crossings_has_none) {
  EXPECT_TRUE(crossings_of({{0, 0}, {1, 0}}, true).value().empty());
  EXPECT_TRUE(crossings_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0.1}}, true).value().empty());
}

TEST(Crossings, sharp_corner_is_no_crossing) {
  EXPECT_TRUE(crossings_of({{0, 0}, {10, 0}, {0, 4}}, true).value().empty());
}

TEST(Crossings, crossing_at_a_vertex_of_one_strand_is_one_crossing) {
  const auto crossings = crossings_of({{0, 0}, {10, 0}, {10, 5}, {5, 0}, {0, -5}}, true).value();
  ASSERT_EQ(crossings.size(), 1U);
  expect_crossing(crossings[0], 0.5, 3, {5, 0}, true, 1);
}

TEST(Crossings, crossing_at_vertices_of_both_strands_is_one_crossing) {
  const auto crossings =
      crossings_of({{0, 1}, {5, 0}, {10, 1}, {10, 5}, {5, 0}, {4, -5}}, true).value();
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

TEST(Crossings, end_inside_a_loop_is_legal_with_a_list) {
  const Drawing shut_in = {{0, 0}, {4, 0}, {4, 3}, {-2, 3}, {-2, -2}, {2, -2}, {2, 5}};
  const auto points = find_double_points(shut_in).value();
  ASSERT_EQ(points.size(), 2U);
  const auto crossings = as_listed(points, {"OUUO"}).value();
  EXPECT_TRUE(crossings[0].first_over);
  EXPECT_FALSE(crossings[1].first_over);
}

TEST(Crossings, list_that_alternates_is_the_alternating_knot) {
  const auto points = find_double_points(trefoil_drawing).value();
  const auto listed = as_listed(points, {"UOUOUO"}).value();
  const auto by_turns = alternating(points, false).value();
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(listed[i].first_over, by_turns[i].first_over);
    EXPECT_EQ(listed[i].sign, by_turns[i].sign);
  }
}

TEST(Crossings, list_tells_each_passage_and_with_it_each_sign) {
  const auto crossings = as_listed(find_double_points(trefoil_drawing).value(), {"OOUUUO"}).value();
  EXPECT_TRUE(crossings[0].first_over);
  EXPECT_TRUE(crossings[1].first_over);
  EXPECT_FALSE(crossings[2].first_over);
  EXPECT_EQ(crossings[0].sign, 1);
  EXPECT_EQ(crossings[1].sign, -1);
  EXPECT_EQ(crossings[2].sign, -1);
  std::string walk;
  for (const Passage& passage : passages_along(crossings)) walk += passage.over ? 'O' : 'U';
  EXPECT_EQ(walk, "OOUUUO");
}

TEST(Crossings, list_of_wrong_length_is_told_with_the_place_of_the_passage) {
  const auto points = find_double_points(trefoil_drawing).value();
  const auto complaint = [&](const std::string& letters) {
    return refusal_of(as_listed(points, {letters, "knot.toml:3:13"}));
  };
  EXPECT_THAT(complaint("OUOUO"),
              StartsWith("knot.toml:3:13: the drawing has 6 passages, 'crossings' has 5 letters; "
                         "passage 6 is at (5, 0); "));
  EXPECT_THAT(complaint("OUOUOUO"), HasSubstr("has 7 letters; passage 6 is at (5, 0)"));
  EXPECT_THAT(complaint("O"), HasSubstr("has 1 letter; passage 2 is at (3, 0)"));
  EXPECT_THAT(refusal_of(as_listed({}, {"OU"})), HasSubstr("does not cross itself"));
}

TEST(Crossings, list_with_one_letter_for_both_passages_of_a_crossing_is_told_with_its_place) {
  EXPECT_THAT(refusal_of(as_listed(find_double_points(trefoil_drawing).value(), {"OUOUUU"})),
              HasSubstr("passages 2 and 5 meet at (3, 0) of the drawing, and both say U"));
}

TEST(Crossings, crossings_survive_points_denser_than_the_tolerance) {
  Drawing dense;
  constexpr int pieces = 20000;
  for (std::size_t i = 0; i + 1 < trefoil_drawing.size(); ++i)
    for (int k = 0; k < pieces / 9; ++k)
      dense.push_back(trefoil_drawing[i] +
                      (trefoil_drawing[i + 1] - trefoil_drawing[i]) * (k / (pieces / 9.0)));
  const auto crossings = crossings_of(dense, true);
  ASSERT_TRUE(crossings.has_value()) << crossings.error().sentence();
  ASSERT_EQ(crossings->size(), 3U);
  EXPECT_NEAR(((*crossings)[1].point - Eigen::Vector2d(3, 0)).norm(), 0, 1e-9);
}

// Every two of its pieces cross.
TEST(Crossings, a_net_is_refused_before_all_its_meshes_are_counted) {
  Drawing star;
  constexpr int points = 2001;
  constexpr int nearly_half = points / 2;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i * nearly_half / points;
    star.emplace_back(std::cos(angle), std::sin(angle));
  }
  EXPECT_THAT(refusal_of(find_double_points(star)),
              HasSubstr("the curve meets itself in more than 20000 places"));
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
  const auto crossings = crossings_of(spiral, true);
  ASSERT_TRUE(crossings.has_value()) << crossings.error().sentence();
  ASSERT_EQ(crossings->size(), 49U);
  for (const Crossing& crossing : *crossings) EXPECT_EQ(std::abs(crossing.sign), 1);
  const double sag = std::pow(2 * std::numbers::pi * 49 / segments, 2) / 8;
  EXPECT_NEAR(crossings->front().point.x(), 0.98, sag);
}

}  // namespace ribbon::crossings_test
