#include "curve/joined_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "curve/over_under.h"
#include "result/refusal.h"

namespace ribbon::joined_drawing_test {

// A loop that begins at the left, passes (0, 0) to the right, comes back from above and goes on
// below. `half` the gap at (0, 0), in the upright strand; drawn as two pieces.
std::vector<DrawnPiece> loop_with_gap(double half) {
  return {{{{-10, 0}, {10, 0}, {10, -10}, {0, -10}, {0, -half}}}, {{{0, half}, {0, 10}}}};
}

Result<std::vector<Crossing>> crossings_of(const std::vector<DrawnPiece>& pieces,
                                           const CurveScene& scene = {}) {
  const auto drawing = joined(pieces);
  if (!drawing) return tl::unexpected(drawing.error());
  return find_double_points(drawing->points).and_then([&](const auto& points) {
    return over_and_under(points, *drawing, scene);
  });
}

TEST(JoinedDrawing, one_piece_has_no_gaps) {
  const auto drawing = joined({{{{0, 0}, {1, 0}}}}).value();
  EXPECT_EQ(drawing.points.size(), 2U);
  EXPECT_TRUE(drawing.gaps.empty());
}

TEST(JoinedDrawing, a_gap_is_where_the_strand_passes_under) {
  const auto crossings = crossings_of(loop_with_gap(1)).value();
  ASSERT_EQ(crossings.size(), 1U);
  EXPECT_TRUE(crossings[0].first_over);
}

TEST(JoinedDrawing, pieces_may_be_drawn_in_any_order_and_direction) {
  auto pieces = loop_with_gap(1);
  std::reverse(pieces[0].points.begin(), pieces[0].points.end());
  std::swap(pieces[0], pieces[1]);
  const auto drawing = joined(pieces).value();
  EXPECT_EQ(drawing.points.front(), Eigen::Vector2d(0, 10));
  EXPECT_EQ(drawing.points.back(), Eigen::Vector2d(-10, 0));
  EXPECT_EQ(drawing.gaps, std::vector<std::size_t>{1});
  EXPECT_FALSE(crossings_of(pieces)->at(0).first_over);
}

TEST(JoinedDrawing, ends_that_meet_have_no_gap) {
  const auto drawing = joined({{{{0, 0}, {1, 0}}}, {{{3, 0}, {1, 0}}, Depth::behind}}).value();
  EXPECT_EQ(drawing.points, (Drawing{{0, 0}, {1, 0}, {3, 0}}));
  EXPECT_TRUE(drawing.gaps.empty());
  ASSERT_EQ(drawing.depths.size(), 1U);
  EXPECT_EQ(drawing.depths[0].begin, 1U);
  EXPECT_EQ(drawing.depths[0].end, 2U);
}

TEST(JoinedDrawing, a_part_behind_the_object_goes_on_over_its_gaps) {
  auto pieces = loop_with_gap(1);
  for (DrawnPiece& piece : pieces) piece.depth = Depth::behind;
  const auto drawing = joined(pieces).value();
  ASSERT_EQ(drawing.depths.size(), 1U);
  EXPECT_EQ(drawing.depths[0].end, drawing.points.size() - 1);
}

TEST(JoinedDrawing, ends_too_far_apart_or_out_of_line_are_told_with_their_place) {
  EXPECT_THAT(refusal_of(joined(loop_with_gap(3))),
              AllOf(HasSubstr("drawing at (0, 3)"), HasSubstr("4 ends")));
  auto bent = loop_with_gap(1);
  bent[1].points[1] = {8, 1};
  EXPECT_THAT(refusal_of(joined(bent)), HasSubstr("drawing at (0, 1)"));
}

TEST(JoinedDrawing, a_gap_that_passes_under_nothing_or_two_strands_is_told) {
  EXPECT_THAT(refusal_of(crossings_of(
                  {{{{-10, 0}, {-1, 0}}}, {{{1, 0}, {10, 0}, {10, 9}, {5, 9}, {5, -9}}}})),
              AllOf(HasSubstr("drawing at (0, 0)"), HasSubstr("under nothing")));
  EXPECT_THAT(refusal_of(crossings_of({{{{-10, -0.4},
                                         {10, -0.4},
                                         {12, 0},
                                         {10, 0.4},
                                         {-10, 0.4},
                                         {-12, -5},
                                         {-10, -10},
                                         {0, -10},
                                         {0, -1}}},
                                       {{{0, 1}, {0, 10}}}})),
              HasSubstr("this gap passes under 2 strands"));
}

TEST(JoinedDrawing, strands_that_cross_without_a_gap_or_with_two_are_told) {
  auto pieces = loop_with_gap(1);
  pieces[1].points.insert(pieces[1].points.end(), {{-5, 10}, {-5, -5}});
  EXPECT_THAT(refusal_of(crossings_of(pieces)),
              AllOf(HasSubstr("drawing at (-5, 0)"), HasSubstr("neither has a gap")));
  EXPECT_THAT(refusal_of(crossings_of({{{{-10, 0}, {-1, 0}}},
                                       {{{1, 0}, {10, 0}, {10, -10}, {0, -10}, {0, -1}}},
                                       {{{0, 1}, {0, 10}}}})),
              AllOf(HasSubstr("drawing at (0, 0)"), HasSubstr("gap")));
}

TEST(JoinedDrawing, pieces_that_close_to_a_loop_are_told) {
  const Drawing half_ring = {{30, 0.3}, {31, 5}, {35, 5}, {36, 0.3}};
  const Drawing other_half = {{36, -0.3}, {35, -5}, {31, -5}, {30, -0.3}};
  EXPECT_THAT(refusal_of(joined({{{{0, 0}, {20, 0}}}, {half_ring}, {other_half}})),
              HasSubstr("close to a loop"));
  EXPECT_THAT(refusal_of(joined({{half_ring}, {other_half}})), HasSubstr("close to a loop"));
}

TEST(JoinedDrawing, gaps_and_a_list_are_one_too_many) {
  CurveScene scene;
  scene.crossings = CrossingList{"OU", "knot.toml:3:13"};
  EXPECT_THAT(refusal_of(crossings_of(loop_with_gap(1), scene)),
              StartsWith("knot.toml:3:13: the gaps of the drawing say already"));
}

}  // namespace ribbon::joined_drawing_test
