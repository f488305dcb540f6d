#include "knot/type/simplify_curve.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "knot/knotted_curves.h"

namespace ribbon::simplify_curve_test {

TEST(SimplifyCurve, a_wavy_line_becomes_one_corner) {
  const Curve wave = sampled(200, [](double way) {
    return Eigen::Vector3d(10 * way, std::sin(30 * way), std::cos(17 * way));
  });
  EXPECT_EQ(simplified(long_curve(wave, {-1, 0, 0.1}, {1, 0.1, 0})).size(), 3U);
}

TEST(SimplifyCurve, a_knot_keeps_what_holds_it) {
  // A trefoil needs six edges; so does a long one, two of them rays.
  const LongCurve knot = simplified(long_curve(torus_knot(2, 3, 300)));
  EXPECT_GE(knot.size(), 6U);
  EXPECT_LE(knot.size(), 12U);
}

bool has_corner(const LongCurve& curve, const Eigen::Vector3d& corner) {
  return std::any_of(curve.begin(), curve.end(), [&corner](const ProjectivePoint& point) {
    return !point.is_direction && point.at == corner;
  });
}

TEST(SimplifyCurve, a_touched_triangle_keeps_the_corner) {
  // The strand passes exactly through the edge between the neighbours of the corner (2, 2, 0).
  LongCurve curve{ProjectivePoint::direction({-1, 0, -0.125})};
  for (const Eigen::Vector3d& point :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 2, 0), Eigen::Vector3d(4, 0, 0),
        Eigen::Vector3d(9, 0, 4), Eigen::Vector3d(2, 0, 4), Eigen::Vector3d(2, 0, -4)})
    curve.push_back(ProjectivePoint::point(point));
  curve.push_back(ProjectivePoint::direction({0.25, 0.5, -1}));
  EXPECT_TRUE(has_corner(simplified(curve), {2, 2, 0}));
}

}  // namespace ribbon::simplify_curve_test
