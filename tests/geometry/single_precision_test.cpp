#include "geometry/single_precision.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace ribbon::single_precision_test {

TEST(SinglePrecision, moves_no_number_farther_than_is_said_and_some_nearly_as_far) {
  std::mt19937_64 random(1);
  for (const double magnitude : {1e-30, 0.3, 1.0, 1.0000001, 7.9, 8.0, 1e30}) {
    double farthest = 0;
    for (int i = 0; i < 10000; ++i) {
      const double number = magnitude * (1 - std::ldexp(static_cast<double>(random() >> 11U), -54));
      farthest = std::max(farthest, std::abs(static_cast<float>(number) - number));
    }
    EXPECT_LE(farthest, largest_rounding(magnitude)) << magnitude;
    EXPECT_GT(farthest, 0.45 * largest_rounding(magnitude)) << magnitude;
  }
}

TEST(SinglePrecision, the_last_place_leads_to_the_next_number) {
  using Limits = std::numeric_limits<float>;
  for (const float number :
       {0.0F, Limits::denorm_min(), Limits::min() / 2, Limits::min(), 0.999F, 1.0F, 3.0F, 1e30F})
    EXPECT_EQ(number + last_place(number), std::nextafter(number, Limits::infinity())) << number;
  EXPECT_EQ(last_place(-3), last_place(3));
  EXPECT_EQ(last_place(Limits::max()), 0x1p104);
}

}  // namespace ribbon::single_precision_test
