#include "simulation/detection/triangle_fans.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ribbon::triangle_fans_test {

// Round vertex 0.
Eigen::Matrix3Xi cone(int sides) {
  Eigen::Matrix3Xi triangles(3, sides);
  for (int side = 0; side < sides; ++side)
    triangles.col(side) << 1 + side, 1 + (side + 1) % sides, 0;
  return triangles;
}

TEST(TriangleFans, are_the_triangles_of_each_vertex) {
  const TriangleFans fans(cone(5), 7);
  ASSERT_EQ(fans.of(0).size(), 5U);
  EXPECT_EQ(fans.of(0)[1], (TriangleFans::Corners{2, 3}));
  ASSERT_EQ(fans.of(3).size(), 2U);
  EXPECT_EQ(fans.of(3)[0], (TriangleFans::Corners{0, 2}));
  EXPECT_EQ(fans.of(3)[1], (TriangleFans::Corners{4, 0}));
  EXPECT_TRUE(fans.of(6).empty());
}

TEST(TriangleFans, of_very_many_are_some_all_round) {
  for (const int sides : {63, 64, 127, 128, 1000, 12345}) {
    SCOPED_TRACE(sides);
    const TriangleFans fans(cone(sides), sides + 1);
    const auto fan = fans.of(0);
    EXPECT_LE(fan.size(), 128U);
    EXPECT_GE(fan.size(), std::min<std::size_t>(sides, 64));
    int before = 0;
    for (const auto& [b, c] : fan) {
      EXPECT_LE(b - before, sides / 64 + 1);
      before = b;
    }
    EXPECT_GE(before, sides - sides / 64);
    EXPECT_EQ(fans.of(sides).size(), 2U);
  }
}

}  // namespace ribbon::triangle_fans_test
