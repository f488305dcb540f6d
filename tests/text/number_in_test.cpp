#include "text/number_in.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ribbon::number_in_test {

TEST(NumberIn, is_what_the_text_says) {
  EXPECT_EQ(number_in<int>("-12"), -12);
  EXPECT_EQ(number_in<double>("2.5e-3"), 2.5e-3);
  EXPECT_EQ(number_in<float>("0.1"), 0.1F);
  EXPECT_TRUE(std::isnan(number_in<double>("nan").value()));
}

TEST(NumberIn, is_nothing_where_the_text_says_more_or_less) {
  for (const char* text : {"", " 1", "1 ", "+1", "1,", "0x1", "--1", "a"}) {
    EXPECT_EQ(number_in<int>(text), std::nullopt) << text;
    EXPECT_EQ(number_in<double>(text), std::nullopt) << text;
  }
  EXPECT_EQ(number_in<int>("1.5"), std::nullopt);
  EXPECT_EQ(number_in<int>("2147483648"), std::nullopt);
  EXPECT_EQ(number_in<double>("1e999"), std::nullopt);
}

}  // namespace ribbon::number_in_test
