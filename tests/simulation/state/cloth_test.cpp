#include "simulation/state/cloth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ribbon::cloth_test {

Cloth with_speeds(double x, double y, double z) {
  Cloth cloth;
  cloth.velocities = Eigen::Vector3d(x, y, z);
  return cloth;
}

TEST(RoundedVelocities, are_the_nearest_of_single_precision) {
  Cloth cloth = with_speeds(1.0 / 3, -0.1, 123456.789012);
  const Eigen::Matrix3Xd expected = cloth.velocities.cast<float>().cast<double>();
  ASSERT_NE(cloth.velocities, expected);
  cloth.round_velocities();
  EXPECT_EQ(cloth.velocities, expected);
  cloth.round_velocities();
  EXPECT_EQ(cloth.velocities, expected);
}

TEST(RoundedVelocities, keep_24_bits_where_single_precision_has_none) {
  for (const int exponent : {-1040, -1000, -200, 200, 990}) {
    Cloth cloth = with_speeds(std::ldexp(1.0 / 3, exponent), std::ldexp(-0.1, exponent), 0);
    const Eigen::Matrix3Xd exact = cloth.velocities;
    cloth.round_velocities();
    for (const int row : {0, 1}) {
      const double rounded = cloth.velocities(row, 0);
      int scale = 0;
      const double digits = std::ldexp(std::frexp(rounded, &scale), 24);
      EXPECT_EQ(digits, std::trunc(digits)) << exponent;
      EXPECT_NEAR(rounded / exact(row, 0), 1, 0x1p-23) << exponent;
    }
    EXPECT_EQ(cloth.velocities(2, 0), 0);
  }
}

}  // namespace ribbon::cloth_test
