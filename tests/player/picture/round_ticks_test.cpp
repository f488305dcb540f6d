#include "player/picture/round_ticks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace ribbon::round_ticks_test {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> texts(double low, double high, int most) {
  const Ticks ticks = round_ticks(low, high, most);
  std::vector<std::string> result;
  for (const double value : ticks.values) result.push_back(ticks.text(value));
  return result;
}

TEST(RoundTicks, are_multiples_of_one_two_or_five) {
  EXPECT_THAT(texts(0, 10, 6), ElementsAre("0", "2", "4", "6", "8", "10"));
  EXPECT_THAT(texts(0, 7.06, 8), ElementsAre("0", "1", "2", "3", "4", "5", "6", "7"));
  EXPECT_THAT(texts(0, 0.297, 4), ElementsAre("0.0", "0.1", "0.2"));
  EXPECT_THAT(texts(-3, 104, 4), ElementsAre("0", "50", "100"));
  EXPECT_THAT(texts(14.2, 17.9, 4), ElementsAre("15", "16", "17"));
  EXPECT_THAT(texts(0, 31000, 4), ElementsAre("0", "10000", "20000", "30000"));
}

TEST(RoundTicks, rounding_loses_no_end) {
  EXPECT_THAT(texts(0, 0.3, 4), ElementsAre("0.0", "0.1", "0.2", "0.3"));
  EXPECT_THAT(texts(0.1, 0.7, 7).size(), 7U);
  EXPECT_THAT(texts(-0.2, 0.2, 5), ElementsAre("-0.2", "-0.1", "0.0", "0.1", "0.2"));
}

TEST(RoundTicks, whatever_the_range_there_are_few_and_they_lie_in_it) {
  for (int step = 0; step <= 104; ++step) {
    const double high = 1e-12 * std::pow(1.7, step);  // up to 1e12
    for (const double low : {0.0, -high / 3, high / 7})
      for (const int most : {2, 5, 9}) {
        const Ticks ticks = round_ticks(low, high, most);
        EXPECT_GE(ticks.values.size(), 1U) << low << " " << high;
        EXPECT_LE(ticks.values.size(), static_cast<std::size_t>(most));
        for (const double value : ticks.values) {
          EXPECT_GE(value, low - 1e-6 * high);
          EXPECT_LE(value, high * (1 + 1e-6));
        }
      }
  }
}

TEST(RoundTicks, of_no_range_there_are_none) {
  EXPECT_THAT(texts(1, 1, 5), IsEmpty());
  EXPECT_THAT(texts(2, 1, 5), IsEmpty());
  EXPECT_THAT(texts(1, 1 + 1e-15, 5), IsEmpty());
  EXPECT_THAT(texts(-1e308, 1e308, 5), IsEmpty());
}

}  // namespace ribbon::round_ticks_test
