#include "knot/type/closed_by_rays.h"

#include <gtest/gtest.h>

#include "knot/knotted_curves.h"
#include "knot/type/knot_names.h"

namespace ribbon::closed_by_rays_test {

std::string type(const Eigen::Vector3d& first, const Eigen::Vector3d& last, const Curve& curve) {
  const auto jones = type_closed_by({first, last}, curve);
  return jones ? knot_text(*jones) : "not known";
}

TEST(ClosedByRays, of_a_knot_that_is_drawn_out_is_its_type) {
  EXPECT_EQ(type({-1, 0.01, 0}, {1, 0, 0.01}, overhand_knot(200)),
            "trefoil, right-handed (3 crossings)");
  EXPECT_EQ(type({0, 0.01, 1}, {0.01, 0, 1}, overhand_knot(200)),
            "trefoil, right-handed (3 crossings)");
}

// Two turns and more, outwards and in again while they sink: both ends lie within them.
TEST(ClosedByRays, of_ends_within_loops_depends_on_the_rays) {
  const Curve coil = sampled(200, [](double way) {
    const double turn = 2 * std::numbers::pi * (2.3 * way);
    const double radius = 1 + 2 * std::sin(std::numbers::pi * way);
    return Eigen::Vector3d(radius * std::cos(turn), radius * std::sin(turn), 0.5 - way);
  });
  const std::string seen = type({0, 0.001, 1}, {0.001, 0, 1}, coil);
  EXPECT_EQ(seen, "unknot");
  EXPECT_EQ(type({0.001, 0.001, 1}, {-0.001, 0, 1}, coil), seen);
  EXPECT_EQ(type({0, 0.001, -1}, {0.001, 0, 1}, coil),
            "cinquefoil knot 5_1, right-handed (5 crossings)");
}

TEST(ClosedByRays, that_meet_the_curve_leave_it_unknown) {
  const Curve curve = overhand_knot(200);
  EXPECT_EQ(type(curve.col(1) - curve.col(0), {1, 0, 0.01}, curve), "not known");
}

}  // namespace ribbon::closed_by_rays_test
