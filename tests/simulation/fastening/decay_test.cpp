#include "simulation/fastening/decay.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ribbon::decay_test {

TEST(Decay, is_that_of_the_exponential) {
  for (int i = -170; i < 40; ++i) {
    const double x = std::pow(1.37, i);
    EXPECT_NEAR(decayed(x) / -std::expm1(-x), 1, 2e-14) << x;
  }
}

TEST(Decay, of_nothing_is_nothing_and_of_very_much_is_all) {
  EXPECT_EQ(decayed(0), 0);
  EXPECT_EQ(decayed(1e12), 1);
}

}  // namespace ribbon::decay_test
