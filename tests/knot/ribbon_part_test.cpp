#include "knot/ribbon_part.h"

#include <gtest/gtest.h>

#include "knot/knotted_curves.h"

namespace ribbon::ribbon_part_test {

constexpr RibbonGrid grid{101, 3};

TEST(RibbonPart, lies_between_two_places_in_either_order) {
  EXPECT_EQ(part_between(grid, 0.2, 0.5), (RibbonPart{20, 50}));
  EXPECT_EQ(part_between(grid, 0.5, 0.2), (RibbonPart{20, 50}));
  EXPECT_EQ(part_between(grid, 0, 1), (RibbonPart{0, 100}));
}

TEST(RibbonPart, has_the_triangles_of_the_whole) {
  const RibbonPart part = part_between(grid, 0.21, 0.5).value();
  EXPECT_EQ(part.first_row, 20) << "quads are split the other way in odd rows";
  const Eigen::Matrix3Xf whole = open_trefoil(grid, 1, 0.1).cast<float>();
  const RibbonGrid own = part.grid(grid);
  const Eigen::Matrix3Xf positions = part.positions(grid, whole);
  ASSERT_EQ(positions.cols(), own.particle_count());
  const int before = 2 * part.first_row * (grid.across - 1);
  for (int t = 0; t < own.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(positions.col(own.triangle(t)[k]), whole.col(grid.triangle(before + t)[k]));
}

TEST(RibbonPart, needs_two_rows) {
  EXPECT_FALSE(part_between(grid, 0.2, 0.2).has_value());
  EXPECT_FALSE(part_between(grid, 0.21, 0.212).has_value());
  EXPECT_TRUE(part_between(grid, 0.2, 0.21).has_value());
  EXPECT_FALSE(part_between({2, 2}, 1, 1).has_value());
}

}  // namespace ribbon::ribbon_part_test
