#include "player/picture/color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ribbon::color_test {

TEST(Color, what_cannot_be_shown_is_clamped) {
  EXPECT_EQ(srgb_byte(-0.3F), 0);
  EXPECT_EQ(srgb_byte(7.0F), 255);
  EXPECT_EQ(srgb_byte(std::numeric_limits<float>::infinity()), 255);
  EXPECT_EQ(srgb_byte(std::numeric_limits<float>::quiet_NaN()), 0);
}

// The standard's formula, in double precision.
double encoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

TEST(Color, every_level_is_the_nearest_one) {
  for (int i = 0; i <= 100'000; ++i) {
    const double linear = i / 100'000.0;
    EXPECT_NEAR(srgb_byte(static_cast<float>(linear)), 255 * encoded(linear), 0.5005) << linear;
  }
}

TEST(Color, picked_colours_come_back) {
  const Color color = from_srgb(0x24406E);
  EXPECT_EQ(srgb_byte(color[0]), 0x24);
  EXPECT_EQ(srgb_byte(color[1]), 0x40);
  EXPECT_EQ(srgb_byte(color[2]), 0x6E);
}

}  // namespace ribbon::color_test
