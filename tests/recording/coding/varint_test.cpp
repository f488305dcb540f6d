#include "recording/coding/varint.h"

#include <gtest/gtest.h>

#include <limits>

namespace ribbon::varint_test {

TEST(Varint, varints_hold_seven_bits_a_byte) {
  std::string bytes;
  put_varint(bytes, 0);
  put_varint(bytes, 127);
  put_varint(bytes, 300);
  EXPECT_EQ(bytes, std::string("\0\x7F\xAC\x02", 4));
  put_varint(bytes, 0xFFFFFFFF);
  std::string_view rest = bytes;
  EXPECT_EQ(take_varint(rest), 0U);
  EXPECT_EQ(take_varint(rest), 127U);
  EXPECT_EQ(take_varint(rest), 300U);
  EXPECT_EQ(take_varint(rest), 0xFFFFFFFFU);
  EXPECT_FALSE(take_varint(rest).has_value());
}

TEST(Varint, an_endless_varint_is_refused) {
  std::string_view bytes = "\x80\x80\x80\x80\x80\x80\x01";
  EXPECT_FALSE(take_varint(bytes).has_value());
}

TEST(Varint, more_than_32_bits_are_refused) {
  std::string_view largest = "\xFF\xFF\xFF\xFF\x0F";
  EXPECT_EQ(take_varint(largest), 0xFFFFFFFFU);
  std::string_view larger = "\xFF\xFF\xFF\xFF\x1F";
  EXPECT_FALSE(take_varint(larger).has_value());
}

TEST(Varint, zigzag_puts_small_numbers_of_either_sign_first) {
  EXPECT_EQ(zigzag(0), 0U);
  EXPECT_EQ(zigzag(-1), 1U);
  EXPECT_EQ(zigzag(1), 2U);
  EXPECT_EQ(zigzag(-2), 3U);
  EXPECT_EQ(zigzag(std::numeric_limits<std::int32_t>::min()), 0xFFFFFFFFU);
  for (const std::int32_t number : {0, 1, -1, 77, std::numeric_limits<std::int32_t>::max(),
                                    std::numeric_limits<std::int32_t>::min()})
    EXPECT_EQ(unzigzag(zigzag(number)), number);
}

}  // namespace ribbon::varint_test
