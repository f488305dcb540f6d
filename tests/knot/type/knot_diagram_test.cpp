#include "knot/type/knot_diagram.h"

#include <gtest/gtest.h>

#include "knot/knotted_curves.h"
#include "knot/type/knot_names.h"

namespace ribbon::knot_diagram_test {

using Pass = KnotDiagram::Pass;

const ProjectivePoint from_above = ProjectivePoint::direction({0.01, 0.02, 1});

TEST(KnotDiagram, three_crossings_of_the_drawn_trefoil_alternate) {
  const auto seen =
      diagram(long_curve(overhand_knot(60), {-1, 0, 0.01}, {1, 0, 0}), from_above).value();
  ASSERT_EQ(seen.crossing_count(), 3);
  EXPECT_EQ(seen.writhe(), 3);
  for (std::size_t k = 0; k + 1 < seen.passes.size(); ++k)
    EXPECT_NE(seen.passes[k].over, seen.passes[k + 1].over);
}

TEST(KnotDiagram, crossings_come_in_the_order_in_which_the_edge_meets_them) {
  // One long edge along x, crossed at x = 3, 1, 2 by the strands that come after it.
  LongCurve curve{ProjectivePoint::direction({-1, 0.01, 0})};
  for (const Eigen::Vector3d& point :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(9, 0, 0), Eigen::Vector3d(3, 4, 1),
        Eigen::Vector3d(3.1, -4, 1), Eigen::Vector3d(1, -4, 3), Eigen::Vector3d(1.1, 4, -2),
        Eigen::Vector3d(2, 4, -2)})
    curve.push_back(ProjectivePoint::point(point));
  curve.push_back(ProjectivePoint::direction({0.01, -1, -0.02}));
  const auto seen = diagram(curve, from_above).value();
  ASSERT_EQ(seen.crossing_count(), 4);
  const auto& passes = seen.passes;
  // After the long edge come the strands at x = 3 and 1, and the last ray at x = 2, which crosses
  // the edge between the two strands as well.
  EXPECT_EQ(passes[2].crossing, passes[3].crossing);
  EXPECT_EQ(passes[0].crossing, passes[5].crossing);
  EXPECT_EQ(passes[1].crossing, passes[6].crossing);
  EXPECT_EQ(passes[4].crossing, passes[7].crossing);
}

TEST(KnotDiagram, a_view_along_an_edge_is_refused) {
  LongCurve curve{ProjectivePoint::direction({-1, 0, 0})};
  for (const Eigen::Vector3d& point : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0, 1),
                                       Eigen::Vector3d(0, 2, 3), Eigen::Vector3d(1, 1, 1)})
    curve.push_back(ProjectivePoint::point(point));
  curve.push_back(ProjectivePoint::direction({1, 0, 0.5}));
  EXPECT_FALSE(diagram(curve, ProjectivePoint::direction({0, 0, 1})));
  EXPECT_TRUE(diagram(curve, ProjectivePoint::direction({0.3, -0.2, 1})));
}

TEST(KnotDiagram, loops_are_taken_out) {
  EXPECT_EQ(reduced({{{0, true}, {0, false}, {1, false}, {1, true}}, {1, -1}}).crossing_count(), 0);
}

TEST(KnotDiagram, a_loop_through_infinity_is_taken_out) {
  const KnotDiagram trefoil = braid_knot({1, 1, 1});
  KnotDiagram with_loop = trefoil;
  with_loop.passes.insert(with_loop.passes.begin(), Pass{3, true});
  with_loop.passes.push_back({3, false});
  with_loop.signs.push_back(1);
  EXPECT_EQ(reduced(with_loop).crossing_count(), 3);
}

TEST(KnotDiagram, a_strand_laid_over_another_is_taken_back) {
  EXPECT_EQ(reduced(braid_knot({1, 1, 1, 2, -1, 1, 2, 2})).crossing_count(), 6);
}

TEST(KnotDiagram, strands_that_embrace_stay) {
  EXPECT_EQ(reduced(braid_knot({1, 1, 1})).crossing_count(), 3);
  EXPECT_EQ(reduced(braid_knot({1, -2, 1, -2})).crossing_count(), 4);
}

TEST(KnotDiagram, a_curve_that_meets_itself_has_none) {
  LongCurve curve{ProjectivePoint::direction({-1, 0, 0.5})};
  for (const Eigen::Vector3d& point : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 0, 0),
                                       Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(1, -1, 0)})
    curve.push_back(ProjectivePoint::point(point));
  curve.push_back(ProjectivePoint::direction({1, 0, 0.25}));
  EXPECT_FALSE(simple_diagram(curve));
}

}  // namespace ribbon::knot_diagram_test
