#include "converter/export/placement.h"

#include <gtest/gtest.h>

namespace ribbon::placement_test {

Eigen::Matrix3Xf two_points() {
  Eigen::Matrix3Xf points(3, 2);
  points << 1, 0.1F,  //
      2, -0.2F,       //
      3, 0.3F;
  return points;
}

TEST(Placement, as_recorded_nothing_is_touched) {
  EXPECT_EQ(Placement{}.place(two_points()), two_points());
}

TEST(Placement, z_up_turns_the_ribbon_about_x_without_rounding) {
  Eigen::Matrix3Xf turned(3, 2);
  turned << 1, 0.1F,  //
      -3, -0.3F,      //
      2, -0.2F;
  EXPECT_EQ(Placement{.up = UpAxis::z}.place(two_points()), turned);
}

TEST(Placement, centimetres_are_a_hundred_a_metre_rounded_once) {
  const Eigen::Matrix3Xf placed = Placement{.metres_per_unit = 0.01}.place(two_points());
  EXPECT_EQ(placed(0, 0), 100);
  EXPECT_EQ(placed(0, 1), static_cast<float>(100 * static_cast<double>(0.1F)));
}

TEST(Placement, a_scale_enlarges_whatever_the_unit) {
  const Placement tenth{.metres_per_unit = 0.01, .scale = 0.1};
  EXPECT_EQ(tenth.place(two_points())(1, 0), 20);
}

}  // namespace ribbon::placement_test
