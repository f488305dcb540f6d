#include "model/placement.h"

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

// How far placing moves a vertex, measured in double precision.
double moved_m(const Placement& placement, const Eigen::Matrix3Xf& recorded) {
  const Eigen::Matrix3Xd exact = placement.factor() * recorded.cast<double>();
  const Eigen::Matrix3Xd placed = placement.place(recorded).cast<double>();
  return (placed - exact).colwise().norm().maxCoeff() / placement.factor();
}

TEST(Placement, no_vertex_moves_further_than_the_bound_says) {
  for (const double scale : {0.1, 0.3, 7.0, 1e-30})
    for (const float reach : {0.01F, 1.6F, 3000.0F}) {
      const Eigen::Matrix3Xf recorded = reach * Eigen::Matrix3Xf::Random(3, 1000);
      const Placement placement{.metres_per_unit = 0.01, .scale = scale};
      EXPECT_LE(moved_m(placement, recorded), placement.rounding_m(recorded));
      EXPECT_GT(moved_m(placement, recorded), placement.rounding_m(recorded) / 4);
    }
}

TEST(Placement, as_recorded_nothing_is_rounded) {
  EXPECT_EQ(Placement{}.rounding_m(two_points()), 0);
  EXPECT_EQ(Placement{.up = UpAxis::z}.rounding_m(two_points()), 0);
}

}  // namespace ribbon::placement_test
