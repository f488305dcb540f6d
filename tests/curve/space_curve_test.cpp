#include "curve/space_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "curve/smooth_plan.h"
#include "curve/trefoil_drawing.h"
#include "result/refusal.h"

namespace ribbon::space_curve_test {

using Eigen::Vector3d;

CurveScene scene_of(const std::vector<Eigen::Vector2d>& points, double unit_m = 1) {
  CurveScene scene;
  scene.drawing = DrawnPoints{points};
  scene.unit_m = unit_m;
  scene.clearance_m = 0.01;
  return scene;
}

SpaceCurve curve_of(const CurveScene& scene, double width_m, int samples) {
  const auto curve = generate_space_curve(scene, {.width_m = width_m, .along = samples});
  EXPECT_TRUE(curve.has_value()) << curve.error().sentence();
  return curve.value();
}

std::string problem_of(const CurveScene& scene, double width_m) {
  return refusal_of(generate_space_curve(scene, {.width_m = width_m, .along = 10}));
}

// The heights (world y) of the passages over a plan point, in order of the walk.
std::vector<double> heights_at(const SpaceCurve& curve, double x, double z) {
  const auto distance = [&](Eigen::Index i) {
    return std::hypot(curve.points(0, i) - x, curve.points(2, i) - z);
  };
  std::vector<double> heights;
  for (Eigen::Index i = 1; i + 1 < curve.points.cols(); ++i)
    if (distance(i) < 1e-3 && distance(i) <= distance(i - 1) && distance(i) < distance(i + 1))
      heights.push_back(curve.points(1, i));
  return heights;
}

TEST(SpaceCurve, straight_line_is_reproduced) {
  const SpaceCurve curve = curve_of(scene_of({{0, 0}, {100, 0}, {1000, 0}}, 0.001), 0.1, 5);
  EXPECT_NEAR(curve.length_m, 1, 1e-12);
  EXPECT_TRUE(curve.crossings.empty());
  for (int i = 0; i < 5; ++i)
    EXPECT_NEAR((curve.points.col(i) - Vector3d(0.25 * i, 0, 0)).norm(), 0, 1e-9);
}

TEST(SpaceCurve, drawing_is_seen_from_the_positive_end_of_the_axis) {
  CurveScene scene = scene_of({{0, 0}, {3, 4}});
  scene.origin = {1, 1};
  const auto expect_ends = [&](Axis axis, const Vector3d& begin, const Vector3d& end) {
    scene.axis = axis;
    const SpaceCurve curve = curve_of(scene, 0.1, 2);
    EXPECT_NEAR((curve.points.col(0) - begin).norm(), 0, 1e-12);
    EXPECT_NEAR((curve.points.col(1) - end).norm(), 0, 1e-12);
  };
  expect_ends(Axis::y, {-1, 0, -1}, {2, 0, 3});
  expect_ends(Axis::z, {-1, 1, 0}, {2, -3, 0});
  expect_ends(Axis::x, {0, 1, 1}, {0, -3, -2});
}

TEST(SpaceCurve, passages_are_half_of_width_and_clearance_above_and_below) {
  CurveScene scene = scene_of(trefoil_drawing, 0.1);
  for (const double over : {0.05, -0.05}) {
    scene.first_passage_over = over > 0;
    const SpaceCurve curve = curve_of(scene, 0.09, 8001);
    double first = over;
    for (const double x : {0.1, 0.3, 0.5}) {
      const auto heights = heights_at(curve, x, 0);
      ASSERT_EQ(heights.size(), 2U) << x;
      EXPECT_NEAR(heights[0], first, 1e-6);
      EXPECT_NEAR(heights[1], -first, 1e-6);
      first = -first;
    }
    EXPECT_EQ(curve.crossings.size(), 3U);
  }
}

TEST(SpaceCurve, heights_point_along_the_axis_towards_the_viewer) {
  CurveScene scene = scene_of(trefoil_drawing, 0.1);
  scene.axis = Axis::z;
  EXPECT_NEAR(curve_of(scene, 0.09, 8001).points.row(2).maxCoeff(), 0.05, 1e-6);
  scene.axis = Axis::x;
  EXPECT_NEAR(curve_of(scene, 0.09, 8001).points.row(0).maxCoeff(), 0.05, 1e-6);
}

TEST(SpaceCurve, ends_lie_in_the_plane_and_no_passage_is_overshot) {
  const SpaceCurve curve = curve_of(scene_of(trefoil_drawing, 0.1), 0.09, 400);
  EXPECT_EQ(curve.points(1, 0), 0);
  EXPECT_EQ(curve.points(1, 399), 0);
  EXPECT_LE(curve.points.row(1).cwiseAbs().maxCoeff(), 0.05 + 1e-12);
}

TEST(SpaceCurve, samples_are_even_along_the_curve) {
  constexpr int groups = 100;
  constexpr int per_group = 1000;
  const SpaceCurve curve = curve_of(scene_of(trefoil_drawing, 0.1), 0.09, groups * per_group + 1);
  for (int g = 0; g < groups; ++g) {
    double length = 0;
    for (int i = g * per_group; i < (g + 1) * per_group; ++i)
      length += (curve.points.col(i + 1) - curve.points.col(i)).norm();
    EXPECT_NEAR(length * groups / curve.length_m, 1, 1e-6);
  }
}

TEST(SpaceCurve, length_of_a_circle_is_right) {
  std::vector<Eigen::Vector2d> points(1000);
  for (int i = 0; i < 1000; ++i) points[i] = {std::cos(i * 0.006), std::sin(i * 0.006)};
  EXPECT_NEAR(curve_of(scene_of(points), 0.1, 10).length_m, 999 * 0.006, 1e-5);
}

TEST(SpaceCurve, smoothing_keeps_the_drawn_points) {
  const SpaceCurve curve = curve_of(scene_of({{0, 0}, {4, 1}, {5, 5}, {2, 8}}), 0.1, 20001);
  for (const Vector3d& drawn : {Vector3d(4, 0, 1), Vector3d(5, 0, 5)})
    EXPECT_LT((curve.points.colwise() - drawn).colwise().norm().minCoeff(), 1e-3);
}

TEST(SpaceCurve, passages_too_close_for_the_width_are_refused_with_a_width_that_fits) {
  const CurveScene scene = scene_of(trefoil_drawing, 0.1);
  const std::string problem = problem_of(scene, 0.5);
  EXPECT_THAT(problem, HasSubstr("drawing at ("));
  EXPECT_THAT(problem, HasSubstr("in metres ("));
  const std::string remedy = "set ribbon.width to ";
  ASSERT_THAT(problem, HasSubstr(remedy));
  const double widest_m = std::stod(problem.substr(problem.find(remedy) + remedy.size()));
  // 45 degrees at the steepest, 1.5 times the mean: at least 2 sqrt(2) / 10 m / 1.5 - clearance.
  EXPECT_GT(widest_m, 0.17);
  EXPECT_LT(widest_m, 0.25);
  EXPECT_EQ(problem_of(scene, widest_m), "");
  EXPECT_NE(problem_of(scene, 1.03 * widest_m), "");
}

TEST(SpaceCurve, passages_too_close_are_squeezed_where_that_is_asked_for) {
  CurveScene scene = scene_of(trefoil_drawing, 0.1);
  const auto squeezed =
      generate_space_curve(scene, {.width_m = 0.5, .along = 20001}, TightPassage::squeeze);
  ASSERT_TRUE(squeezed.has_value()) << squeezed.error().sentence();
  const std::vector<double> heights = heights_at(*squeezed, 0.1, 0);
  ASSERT_EQ(heights.size(), 2U);
  const double gap_m = std::abs(heights[0] - heights[1]);
  // As in the test above: between 0.17 and 0.25 m of width, and 0.01 m of clearance.
  EXPECT_GT(gap_m, 0.18);
  EXPECT_LT(gap_m, 0.26);
  // Where there is room nothing is squeezed.
  EXPECT_EQ(
      generate_space_curve(scene, {.width_m = 0.1, .along = 100}, TightPassage::squeeze)->points,
      generate_space_curve(scene, {.width_m = 0.1, .along = 100})->points);
}

// Of a loop whose two strands are a share s and 1 - s of its length away from its first end.
TEST(SpaceCurve, strands_of_different_width_are_half_of_both_and_the_clearance_apart) {
  const CurveScene scene = scene_of({{-4, 0}, {4, 0}, {4, 4}, {0, 4}, {0, -4}}, 0.1);
  const RibbonScene tapered{
      .width_m = 0.1, .profile = WidthProfile{{{0, 0.02}, {1, 0.18}}}, .along = 20001};
  const auto curve = generate_space_curve(scene, tapered);
  ASSERT_TRUE(curve.has_value()) << curve.error().sentence();
  const std::vector<double> heights = heights_at(*curve, 0, 0);
  ASSERT_EQ(heights.size(), 2U);
  EXPECT_NEAR(heights[0] - heights[1], 0.1 + 0.01, 2e-3);
  const RibbonScene even{.width_m = 0.18, .along = 20001};
  const std::vector<double> wide = heights_at(generate_space_curve(scene, even).value(), 0, 0);
  EXPECT_NEAR(wide[0] - wide[1], 0.19, 1e-6);
}

TEST(SpaceCurve, crossing_at_the_very_end_is_passed_near_the_plane) {
  std::vector<Eigen::Vector2d> points = trefoil_drawing;
  points.front() = {0.9, -0.1};
  const auto heights = heights_at(curve_of(scene_of(points, 0.1), 0.09, 80001), 0.1, 0);
  ASSERT_EQ(heights.size(), 2U);
  EXPECT_LT(heights[0], 0.015);
  EXPECT_GT(heights[0] - heights[1], 0.1 - 1e-6);
}

TEST(SpaceCurve, a_loop_too_small_for_the_width_is_told_by_its_passages) {
  const std::string problem =
      problem_of(scene_of({{-9, 0}, {0, 0}, {0.5, -0.5}, {0.5, -1}, {0, -1}, {0, 9}}, 0.1), 0.3);
  EXPECT_THAT(problem, HasSubstr("drawing at (0, 0)"));
  EXPECT_THAT(problem, HasSubstr("the way from passage 1 to 2 is 0."));
}

TEST(SpaceCurve, curve_is_level_between_passages_that_are_both_over) {
  CurveScene scene = scene_of(trefoil_drawing, 0.1);
  scene.crossings = CrossingList{"OOOUUU"};
  const SpaceCurve curve = curve_of(scene, 0.09, 8001);
  int level = 0;
  for (int i = 0; i < 8001; ++i) {
    const bool among_the_first =
        curve.points(0, i) > 0.1 && curve.points(0, i) < 0.5 && std::abs(curve.points(2, i)) < 0.12;
    if (!among_the_first || curve.points(1, i) < 0) continue;
    EXPECT_NEAR(curve.points(1, i), 0.05, 1e-12);
    ++level;
  }
  EXPECT_GT(level, 500);
}

TEST(SpaceCurve, list_that_alternates_gives_the_bits_of_the_alternating_curve) {
  CurveScene scene = scene_of(trefoil_drawing, 0.1);
  const SpaceCurve by_turns = curve_of(scene, 0.09, 400);
  scene.crossings = CrossingList{"OUOUOU"};
  EXPECT_EQ(curve_of(scene, 0.09, 400).points, by_turns.points);
}

TEST(SpaceCurve, equal_letters_let_strands_run_closer_than_letters_that_alternate) {
  CurveScene scene = scene_of(trefoil_drawing, 0.1);
  EXPECT_NE(problem_of(scene, 0.3), "");
  scene.crossings = CrossingList{"OOOUUU"};
  EXPECT_EQ(problem_of(scene, 0.3), "");
}

TEST(SpaceCurve, smoothing_that_would_cross_elsewhere_is_refused) {
  // Rounded, the corner at (10, 0) bulges across the strand that passes just outside.
  const std::string problem =
      problem_of(scene_of({{0, 0}, {10, 0}, {10, 10}, {20, 10}, {20, -0.2}, {0, -0.2}}), 0.1);
  EXPECT_THAT(problem, HasSubstr("smoothed"));
  EXPECT_THAT(problem, HasSubstr("drawing at ("));
}

TEST(SpaceCurve, repeated_points_are_dropped) {
  const SpaceCurve curve = curve_of(scene_of({{0, 0}, {0, 0}, {1, 0}, {1, 0}}), 0.1, 3);
  EXPECT_NEAR(curve.length_m, 1, 1e-12);
  EXPECT_THAT(problem_of(scene_of({{1, 1}, {1, 1}}), 0.1), HasSubstr("no length"));
}

TEST(SpaceCurve, points_that_are_no_numbers_are_refused) {
  EXPECT_NE(problem_of(scene_of({{0, 0}, {NAN, 1}}), 0.1), "");
  EXPECT_NE(problem_of(scene_of({{0, 0}, {1e300, 1}}), 0.1), "");
}

}  // namespace ribbon::space_curve_test
