#include "simulation/yielding.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/planted_penetrations.h"

namespace ribbon {
namespace {

const RibbonGrid grid{101, 2};

TEST(Yielding, leaves_the_force_of_an_unstretched_ribbon_alone) {
  Yielding yielding(grid, 100, 0.05);
  EXPECT_EQ(yielding.feel(flat_ribbon(grid)), 1);
}

TEST(Yielding, gives_way_step_by_step_while_the_ribbon_is_stretched) {
  Yielding yielding(grid, 100, 0.05);
  Eigen::Matrix3Xd stretched = flat_ribbon(grid);
  stretched.row(0) *= 1.06;
  double share = 1;
  for (int step = 0; step < 14; ++step) share = yielding.feel(stretched);
  EXPECT_NEAR(share, std::pow(0.95, 14), 1e-12);
}

TEST(Yielding, comes_back_to_all_of_the_force_and_no_more) {
  Yielding yielding(grid, 100, 0.05);
  Eigen::Matrix3Xd stretched = flat_ribbon(grid);
  stretched.row(0) *= 1.06;
  for (int step = 0; step < 5; ++step) yielding.feel(stretched);
  double share = 0;
  for (int step = 0; step < 8; ++step) share = yielding.feel(flat_ribbon(grid));
  EXPECT_DOUBLE_EQ(share, 1);
}

TEST(Yielding, does_not_mind_one_edge_in_a_hundred) {
  // By hand: 200 edges along, so two may be stretched.
  Yielding yielding(grid, 100, 0.05);
  Eigen::Matrix3Xd two_stretched = flat_ribbon(grid);
  two_stretched.row(0).tail(2).array() += 0.5;
  EXPECT_EQ(yielding.feel(two_stretched), 1);
  two_stretched(0, 0) -= 0.5;
  EXPECT_LT(yielding.feel(two_stretched), 1);
}

}  // namespace
}  // namespace ribbon
