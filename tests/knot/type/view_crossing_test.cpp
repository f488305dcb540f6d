#include "knot/type/view_crossing.h"

#include <gtest/gtest.h>

namespace ribbon::view_crossing_test {

ProjectivePoint point(double x, double y, double z) {
  return ProjectivePoint::point({x, y, z});
}
const ProjectivePoint from_above = ProjectivePoint::direction({0, 0, 1});
const ProjectivePoint from_below = ProjectivePoint::direction({0, 0, -1});

TEST(ViewCrossing, upper_strand_turned_counter_clockwise_to_the_lower_is_right_handed) {
  // Eastward over northward.
  const ViewCrossing seen =
      view_crossing(point(-1, 0, 1), point(1, 0, 1), point(0, -1, 0), point(0, 1, 0), from_above);
  EXPECT_EQ(seen.seen, ViewOfEdges::crossing);
  EXPECT_EQ(seen.sign, 1);
  EXPECT_TRUE(seen.first_over);
}

TEST(ViewCrossing, seen_from_behind_the_sign_stays_and_the_other_is_over) {
  const ViewCrossing seen =
      view_crossing(point(-1, 0, 1), point(1, 0, 1), point(0, -1, 0), point(0, 1, 0), from_below);
  EXPECT_EQ(seen.sign, 1);
  EXPECT_FALSE(seen.first_over);
}

TEST(ViewCrossing, the_mirror_image_is_left_handed) {
  const ViewCrossing seen =
      view_crossing(point(-1, 0, -1), point(1, 0, -1), point(0, -1, 0), point(0, 1, 0), from_above);
  EXPECT_EQ(seen.sign, -1);
  EXPECT_FALSE(seen.first_over);
}

TEST(ViewCrossing, a_ray_crosses_like_a_long_edge) {
  const ViewCrossing seen =
      view_crossing(ProjectivePoint::direction({-1, 0.01, 0.1}), point(1, 0, 1), point(-50, -9, 0),
                    point(-50, 9, 0), from_above);
  EXPECT_EQ(seen.seen, ViewOfEdges::crossing);
  EXPECT_EQ(seen.sign, 1);
}

TEST(ViewCrossing, edges_side_by_side_are_apart) {
  EXPECT_EQ(
      view_crossing(point(-1, 0, 1), point(1, 0, 1), point(2, -1, 0), point(2, 1, 0), from_above)
          .seen,
      ViewOfEdges::apart);
}

TEST(ViewCrossing, an_end_on_the_other_edge_is_doubtful) {
  EXPECT_EQ(
      view_crossing(point(-1, 0, 1), point(1, 0, 1), point(0, 0, 0), point(0, 1, 0), from_above)
          .seen,
      ViewOfEdges::doubtful);
}

TEST(ViewCrossing, edges_that_meet_are_doubtful_from_everywhere) {
  for (const Eigen::Vector3d& view : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0.3, 0.2, -1)})
    EXPECT_EQ(view_crossing(point(-1, 0, 0), point(1, 0, 0), point(0, -1, 0), point(0, 1, 0),
                            ProjectivePoint::direction(view))
                  .seen,
              ViewOfEdges::doubtful);
}

}  // namespace ribbon::view_crossing_test
