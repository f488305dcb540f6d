#include "geometry/angles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace ribbon::angles_test {

// Near multiples of pi/4, where the reduction changes, and in between.
template <class Visit>
void for_each_angle(const Visit& visit) {
  for (int eighth = -4000; eighth <= 4000; ++eighth)
    for (const double beside : {0.0, 1e-300, 1e-9, -1e-9, 0.1, 0.5})
      visit(eighth * std::numbers::pi / 4 + beside);
  for (int i = 0; i < 5000; ++i) visit(std::ldexp(1.0, i % 20) * (0.5 + i / 10000.0));
}

TEST(Angles, cosine_and_sine_are_those_of_long_double) {
  long double worst = 0;
  for_each_angle([&](double angle) {
    worst = std::max(worst, std::abs(cosine(angle) - std::cos(static_cast<long double>(angle))));
    worst = std::max(worst, std::abs(sine(angle) - std::sin(static_cast<long double>(angle))));
  });
  EXPECT_LE(worst, 4e-16L);
  EXPECT_GT(worst, 0);
}

TEST(Angles, cosine_and_sine_are_even_odd_and_on_the_circle) {
  for_each_angle([](double angle) {
    ASSERT_EQ(cosine(-angle), cosine(angle)) << angle;
    ASSERT_EQ(sine(-angle), -sine(angle)) << angle;
    ASSERT_NEAR(cosine(angle) * cosine(angle) + sine(angle) * sine(angle), 1, 1e-15) << angle;
  });
  EXPECT_EQ(cosine(0), 1);
  EXPECT_EQ(sine(0), 0);
}

TEST(Angles, of_angles_that_are_too_large_nothing_is_known) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(std::isnan(cosine(1e6)));
  for (const double angle : {1.001e6, -1.001e6, infinity, -infinity, infinity - infinity}) {
    EXPECT_TRUE(std::isnan(cosine(angle))) << angle;
    EXPECT_TRUE(std::isnan(sine(angle))) << angle;
  }
}

TEST(Angles, the_polar_angle_is_that_of_long_double) {
  long double worst = 0;
  for (int i = -60; i <= 60; ++i)
    for (int k = 0; k < 97; ++k) {
      const double x = std::ldexp(1 + k / 97.0, i) * (k % 2 == 0 ? 1 : -1);
      const double y = k % 4 < 2 ? 1.5 : -1.5;
      const long double exact =
          std::atan2(static_cast<long double>(y), static_cast<long double>(x));
      worst = std::max(worst, std::abs(polar_angle(x, y) / exact - 1));
    }
  EXPECT_LE(worst, 1e-15L);
}

TEST(Angles, the_polar_angle_on_the_axes_and_nowhere) {
  EXPECT_EQ(polar_angle(3, 0), 0);
  EXPECT_EQ(polar_angle(0, 3), std::numbers::pi / 2);
  EXPECT_EQ(polar_angle(-3, 0), std::numbers::pi);
  EXPECT_EQ(polar_angle(-3, -0.0), std::numbers::pi);
  EXPECT_EQ(polar_angle(0, -3), -std::numbers::pi / 2);
  EXPECT_EQ(polar_angle(0, 0), 0);
}

TEST(Angles, the_polar_angle_leads_back) {
  for (int i = -31; i <= 31; ++i)
    EXPECT_NEAR(polar_angle(cosine(0.1 * i), sine(0.1 * i)), 0.1 * i, 2e-15);
}

// Bits, so that every build is known to compute the same.
TEST(Angles, have_the_same_bits_everywhere) {
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&](double value) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3;
  };
  for (int i = -1000; i <= 1000; ++i) {
    add(cosine(0.37 * i));
    add(sine(0.37 * i));
    add(polar_angle(0.25 * i, 3));
  }
  EXPECT_EQ(hash, 11337076580285339117U);
}

}  // namespace ribbon::angles_test
