#include "recorder/tying.h"

#include <gtest/gtest.h>

#include "result/refusal.h"

namespace ribbon::tying_test {

constexpr RibbonGrid grid{80, 3};
const ObjectAxis axis{{Eigen::Vector3d(0, 0.2, 0), Eigen::Vector3d::UnitZ()}, {{-9, 9}}};

// A band 0.02 wide along a trefoil drawn as a polynomial; `depth` -1 is its mirror image.
Eigen::Matrix3Xd open_trefoil(double depth) {
  Eigen::Matrix3Xd positions(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p) {
    const double t = 2.2 * (2.0 * grid.row(p) / (grid.along - 1) - 1);
    positions.col(p) << t * (t * t - 3), t * t * (t * t - 4),
        depth * t * (t * t * t * t - 10) / 5 + 0.02 * (grid.column(p) - 1);
  }
  return positions;
}

TEST(Tying, a_ribbon_that_was_moved_a_little_is_tied_as_before) {
  EXPECT_TRUE(check_tying(grid, axis, open_trefoil(1), open_trefoil(0.9)).has_value());
}

TEST(Tying, a_strand_moved_through_another_is_told_with_both_knots) {
  EXPECT_THAT(refusal_of(check_tying(grid, std::nullopt, open_trefoil(1), open_trefoil(-1))),
              AllOf(HasSubstr("left-handed"), HasSubstr("right-handed")));
}

TEST(Tying, a_ribbon_moved_to_the_other_side_of_the_object_is_told) {
  Eigen::Matrix3Xd beside = open_trefoil(1);
  beside.row(0).array() += 50;
  EXPECT_FALSE(check_tying(grid, axis, open_trefoil(1), beside).has_value());
  const ObjectAxis short_one{axis.line, {{-9, -8}}};
  EXPECT_THAT(refusal_of(check_tying(grid, short_one, open_trefoil(1), beside)),
              HasSubstr("0 turns round the object"));
}

}  // namespace ribbon::tying_test
