#include "text/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>

namespace ribbon::number_text_test {

TEST(NumberText, runs_of_numbers_are_drawn_together) {
  EXPECT_EQ(number_list({}), "");
  EXPECT_EQ(number_list({4}), "4");
  EXPECT_EQ(number_list({3, 7, 8, 9, 12}), "3, 7-9, 12");
  EXPECT_EQ(number_list({3, 2, 1}), "3, 2, 1");
  EXPECT_EQ(number_list({1, 2}), "1-2");
}

TEST(NumberText, shortest_has_as_many_digits_as_the_number_needs) {
  EXPECT_EQ(shortest(20), "20");
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(shortest(-1e300), "-1e+300");
}

TEST(NumberText, decimals_are_fixed_and_short_numbers_are_short) {
  EXPECT_EQ(decimals(4.1, 2), "4.10");
  EXPECT_EQ(decimals(0.96, 1), "1.0");
  EXPECT_EQ(short_number(0.25), "0.25");
  EXPECT_EQ(short_number(0.00001), "1e-05");
}

TEST(NumberText, lengths_have_significant_digits_in_a_unit_that_fits) {
  EXPECT_EQ(length_text(0.0000123456, 3), "0.0123 mm");
  EXPECT_EQ(length_text(0.0125, 3), "12.5 mm");
  EXPECT_EQ(length_text(0.999, 3), "999 mm");
  EXPECT_EQ(length_text(0.9994, 3), "999 mm");
  EXPECT_EQ(length_text(0.9995001, 3), "1 m");
  EXPECT_EQ(length_text(0.9996, 3), "1 m");
  EXPECT_EQ(length_text(86.6842, 3), "86.7 m");
  EXPECT_EQ(length_text(1858.08, 6), "1858.08 m");
  EXPECT_EQ(length_text(0, 3), "0 mm");
}

TEST(NumberText, bounds_are_rounded_to_where_they_hold) {
  EXPECT_EQ(short_number(1.2341, 3, Rounding::up), "1.24");
  EXPECT_EQ(short_number(1.2349, 3, Rounding::down), "1.23");
  EXPECT_EQ(short_number(-1.2341, 3, Rounding::up), "-1.23");
  EXPECT_EQ(short_number(-1.2341, 3, Rounding::down), "-1.24");
  EXPECT_EQ(short_number(9.991, 3, Rounding::up), "10");
  EXPECT_EQ(short_number(9.999, 3, Rounding::down), "9.99");
  EXPECT_EQ(short_number(10.001, 3, Rounding::up), "10.1");
  EXPECT_EQ(short_number(1e-9, 3, Rounding::up), "1e-09");
  EXPECT_EQ(short_number(100 * 0.07, 6, Rounding::up), "7") << "it is 7.000000000000001";
  EXPECT_EQ(short_number(0, 3, Rounding::down), "0");
  EXPECT_EQ(metres(0.12345, Rounding::up), "0.124 m");
  EXPECT_EQ(length_text(0.9996, 3, Rounding::down), "999 mm");
  EXPECT_EQ(length_text(0.9991, 3, Rounding::up), "1 m");
  EXPECT_EQ(length_text(1.0001, 3, Rounding::up), "1.01 m");
  EXPECT_EQ(length_text(1.2e-5, 6, Rounding::up), "0.012 mm");
}

TEST(NumberText, a_bound_told_in_any_digits_is_one) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-12, 12);
  for (int trial = 0; trial < 10'000; ++trial) {
    const double number = std::pow(10, exponent(random));
    const int digits = 1 + trial % 8;
    const double up = std::stod(short_number(number, digits, Rounding::up));
    const double down = std::stod(short_number(number, digits, Rounding::down));
    EXPECT_LE(down, number) << digits;
    EXPECT_GE(up, number) << digits;
    EXPECT_LE(up - down, 2.01 * std::pow(10, 1 - digits) * number);
  }
}

TEST(NumberText, checksums_have_eight_digits) {
  EXPECT_EQ(hexadecimal(0x8a2f33), "008a2f33");
  EXPECT_EQ(hexadecimal(0xffffffff), "ffffffff");
}

TEST(NumberText, sentences_are_filled_in_with_numbers_and_words) {
  const std::string knot = "knot";
  EXPECT_EQ(filled_in("{}: frame {} of {}", knot, 3, std::uint64_t{7}), "knot: frame 3 of 7");
  EXPECT_EQ(filled_in("{:.1f} s in {} {}", 0.96, -2L, "steps"), "1.0 s in -2 steps");
  EXPECT_EQ(filled_in("{:.3g} m {}", 0.012345, knot.c_str()), "0.0123 m knot");
  EXPECT_EQ(filled_in("{:<5}{:>6.1f}", "a", 2.0), "a       2.0");
  EXPECT_EQ(filled_in("100 %"), "100 %");
  EXPECT_EQ(filled_in("{}", "{}"), "{}") << "values are no patterns";
}

TEST(NumberText, the_largest_number_has_room) {
  EXPECT_EQ(decimals(-1.7e308, 3).size(), 314U);
}

}  // namespace ribbon::number_text_test
