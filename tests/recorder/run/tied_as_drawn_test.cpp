#include "recorder/run/tied_as_drawn.h"

#include <gtest/gtest.h>

#include "knot/knotted_curves.h"
#include "result/refusal.h"

namespace ribbon::tied_as_drawn_test {

constexpr RibbonGrid grid{80, 3};
const ObjectAxis axis{{Eigen::Vector3d(0, 0.2, 0), Eigen::Vector3d::UnitZ()}, {{-9, 9}}};

Eigen::Matrix3Xd trefoil(double depth) {
  return open_trefoil(grid, depth, 0.04);
}

TEST(TiedAsDrawn, a_ribbon_that_was_moved_a_little_is_tied_as_before) {
  EXPECT_TRUE(check_tied_as_drawn(grid, axis, trefoil(1), trefoil(0.9)).has_value());
}

TEST(TiedAsDrawn, a_strand_moved_through_another_is_told_with_both_knots) {
  EXPECT_THAT(refusal_of(check_tied_as_drawn(grid, std::nullopt, trefoil(1), trefoil(-1))),
              AllOf(HasSubstr("left-handed"), HasSubstr("right-handed")));
}

TEST(TiedAsDrawn, a_ribbon_moved_to_the_other_side_of_the_object_is_told) {
  Eigen::Matrix3Xd beside = trefoil(1);
  beside.row(0).array() += 50;
  EXPECT_FALSE(check_tied_as_drawn(grid, axis, trefoil(1), beside).has_value());
  const ObjectAxis short_one{axis.line, {{-9, -8}}};
  EXPECT_THAT(refusal_of(check_tied_as_drawn(grid, short_one, trefoil(1), beside)),
              HasSubstr("0 turns round the object"));
}

}  // namespace ribbon::tied_as_drawn_test
