#include "curve/catmull_rom.h"

#include <gtest/gtest.h>

namespace ribbon::catmull_rom_test {

using Eigen::Vector2d;

TEST(CatmullRom, passes_through_its_middle_points) {
  const Vector2d p1(1, 2);
  const Vector2d p2(1.1, 2);
  const Cubic cubic = catmull_rom({0, 0}, p1, p2, {5, -4});
  EXPECT_EQ(cubic.at(0), p1);
  EXPECT_EQ(cubic.at(1), p2);
}

TEST(CatmullRom, is_the_usual_one_between_evenly_spaced_points) {
  // (-p0 + 9 p1 + 9 p2 - p3) / 16
  const Vector2d middle = catmull_rom({0, 0}, {1, 1}, {2, 0}, {3, 1}).at(0.5);
  EXPECT_NEAR((middle - Vector2d(1.5, 0.5)).norm(), 0, 1e-15);
}

TEST(CatmullRom, stays_on_a_line_and_goes_forward_however_uneven_the_points) {
  const Cubic cubic = catmull_rom({0, 0}, {1, 1}, {1.01, 1.01}, {9, 9});
  double before = 1;
  for (int k = 1; k <= 100; ++k) {
    const Vector2d p = cubic.at(k / 100.0);
    EXPECT_NEAR(p.x(), p.y(), 1e-12);
    EXPECT_GT(p.x(), before);
    before = p.x();
  }
}

}  // namespace ribbon::catmull_rom_test
