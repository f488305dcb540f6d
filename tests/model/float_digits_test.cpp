#include "model/float_digits.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

namespace ribbon::float_digits_test {

constexpr char untouched = '#';

std::string digits_of(float number) {
  std::array<char, float_digits_room + 1> text;
  text.fill(untouched);
  char* const end = write_digits(text.data(), number);
  EXPECT_EQ(text.back(), untouched) << number;
  return {text.data(), end};
}

std::string shortest_of(float number) {
  std::array<char, 64> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

float read_back(const std::string& digits) {
  float number = NAN;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  EXPECT_EQ(read.ptr, digits.data() + digits.size()) << digits;
  return number;
}

// Every 60 thousandth number there is, and the powers of two, whose neighbours are not equally far
// away, with theirs.
template <class See>
void for_many_numbers(const See& see) {
  for (std::uint64_t bits = 0; bits <= 0xffffffff; bits += 60'013)
    see(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  for (int exponent = -149; exponent < 128; ++exponent)
    for (const float number : {std::ldexp(1.0F, exponent), -std::ldexp(1.0F, exponent)})
      for (const float towards : {-HUGE_VALF, number, HUGE_VALF})
        see(std::nextafter(number, towards));
}

TEST(FloatDigits, read_back_as_the_same_number) {
  for_many_numbers([](float number) {
    if (std::isfinite(number)) {
      EXPECT_EQ(read_back(digits_of(number)), number);
    }
  });
}

TEST(FloatDigits, are_those_that_the_standard_library_finds) {
  for_many_numbers([](float number) {
    const std::string digits = digits_of(number);
    const std::string shortest = shortest_of(number);
    if (shortest.find('e') == std::string::npos)
      EXPECT_EQ(digits, shortest);
    else  // 0.0007 for 7e-04
      EXPECT_LE(digits.size(), shortest.size() + 1);
  });
}

TEST(FloatDigits, coordinates_are_written_without_an_exponent) {
  EXPECT_EQ(digits_of(0.0007F), "0.0007");
  EXPECT_EQ(digits_of(-0.0003F), "-0.0003");
  EXPECT_EQ(digits_of(0.1F), "0.1");
  EXPECT_EQ(digits_of(-1.00390625F), "-1.0039062");
  EXPECT_EQ(digits_of(12345.678F), "12345.678");
  EXPECT_EQ(digits_of(8388607.5F), "8388607.5");
  EXPECT_EQ(digits_of(0.99999994F), "0.99999994");
  EXPECT_EQ(digits_of(0.0F), "0");
  EXPECT_EQ(digits_of(-3.0F), "-3");
}

}  // namespace ribbon::float_digits_test
