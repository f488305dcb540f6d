#include "simulation/fastening/yielding.h"

#include <gtest/gtest.h>

#include "simulation/published/planted_penetrations.h"

namespace ribbon::yielding_test {

const RibbonGrid grid{101, 2};

double share_at(double stretch) {
  Yielding yielding(grid, 100, 0.05);
  Eigen::Matrix3Xd stretched = flat_ribbon(grid);
  stretched.row(0) *= 1 + stretch;
  return yielding.feel(stretched);
}

TEST(Yielding, leaves_the_force_of_a_slightly_stretched_ribbon_alone) {
  EXPECT_EQ(share_at(-0.1), 1);
  EXPECT_EQ(share_at(0), 1);
  EXPECT_EQ(share_at(0.024), 1);
}

TEST(Yielding, gives_way_in_proportion_to_the_stretch) {
  EXPECT_NEAR(share_at(0.0375), 0.75, 1e-12);
  EXPECT_NEAR(share_at(0.05), 0.5, 1e-12);
  EXPECT_NEAR(share_at(0.0625), 0.25, 1e-12);
}

TEST(Yielding, gives_way_altogether_at_one_and_a_half_of_its_strain) {
  EXPECT_EQ(share_at(0.0751), 0);
  EXPECT_EQ(share_at(3), 0);
}

TEST(Yielding, does_not_mind_one_edge_in_a_hundred) {
  // By hand: 200 edges along, so two may be stretched.
  Yielding yielding(grid, 100, 0.05);
  Eigen::Matrix3Xd two_stretched = flat_ribbon(grid);
  two_stretched.row(0).tail(2).array() += 0.5;
  EXPECT_EQ(yielding.feel(two_stretched), 1);
  two_stretched(0, 0) -= 0.5;
  EXPECT_EQ(yielding.feel(two_stretched), 0);
}

}  // namespace ribbon::yielding_test
