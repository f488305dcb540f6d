#include "text/number_text.h"

#include <gtest/gtest.h>

namespace ribbon::number_text_test {

TEST(NumberText, runs_of_numbers_are_drawn_together) {
  EXPECT_EQ(number_list({}), "");
  EXPECT_EQ(number_list({4}), "4");
  EXPECT_EQ(number_list({3, 7, 8, 9, 12}), "3, 7-9, 12");
  EXPECT_EQ(number_list({3, 2, 1}), "3, 2, 1");
  EXPECT_EQ(number_list({1, 2}), "1-2");
}

TEST(NumberText, decimals_are_fixed_and_short_numbers_are_short) {
  EXPECT_EQ(decimals(4.1, 2), "4.10");
  EXPECT_EQ(decimals(0.96, 1), "1.0");
  EXPECT_EQ(short_number(0.25), "0.25");
  EXPECT_EQ(short_number(0.00001), "1e-05");
}

TEST(NumberText, the_largest_number_has_room) {
  EXPECT_EQ(decimals(-1.7e308, 3).size(), 314U);
}

}  // namespace ribbon::number_text_test
