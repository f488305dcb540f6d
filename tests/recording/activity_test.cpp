#include "recording/activity.h"

#include <gtest/gtest.h>

namespace ribbon {
namespace {

const PaddedGrid grid(RibbonGrid{30, 5});

Residuals no_residuals() {
  Residuals residuals;
  for (Field& plane : residuals) plane.assign(grid.size(), 0);
  return residuals;
}

TEST(Activity, at_first_all_particles_are_calm) {
  const Activity activity(grid);
  EXPECT_EQ(activity.expected_class(2, grid.at(29, 4)), 0U);
}

TEST(Activity, restless_particles_and_their_neighbours_are_expected_to_stay_so) {
  Activity activity(grid);
  Residuals residuals = no_residuals();
  residuals[0][grid.at(10, 2)] = -40;
  activity.remember(residuals);
  // Activity (0 + 16 * 40 + 1) / 2 = 320; twice that, 640, has ten binary digits.
  EXPECT_EQ(activity.expected_class(0, grid.at(10, 2)), 5U);
  // Its neighbours see 320, nine digits.
  EXPECT_EQ(activity.expected_class(0, grid.at(10, 3)), 4U);
  EXPECT_EQ(activity.expected_class(0, grid.at(9, 2)), 4U);
  EXPECT_EQ(activity.expected_class(0, grid.at(9, 3)), 0U) << "not diagonally";
  EXPECT_EQ(activity.expected_class(1, grid.at(10, 2)), 0U) << "components are apart";
}

TEST(Activity, it_fades_and_is_forgotten) {
  Activity activity(grid);
  Residuals residuals = no_residuals();
  residuals[1][grid.at(0, 0)] = 1'000'000'000;  // counts as 2047: (16 * 2047 + 1) / 2 = 16376
  activity.remember(residuals);
  EXPECT_EQ(activity.expected_class(1, grid.at(0, 0)), 7U) << "the largest there is";
  for (int frame = 0; frame < 9; ++frame) activity.remember(no_residuals());
  // Halved nine times, rounding up on the way: 32; twice that has seven digits.
  EXPECT_EQ(activity.expected_class(1, grid.at(0, 0)), 2U);
  activity.forget();
  EXPECT_EQ(activity.expected_class(1, grid.at(0, 0)), 0U);
}

}  // namespace
}  // namespace ribbon
