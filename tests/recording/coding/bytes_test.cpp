#include "recording/coding/bytes.h"

#include <gtest/gtest.h>

namespace ribbon::bytes_test {

using namespace std::string_view_literals;

TEST(Bytes, numbers_lie_with_their_low_byte_first) {
  std::string bytes;
  put<std::uint8_t>(bytes, 0xAB);
  put<std::uint16_t>(bytes, 0x0102);
  put<std::uint32_t>(bytes, 0x03040506);
  put<double>(bytes, 1.0);  // 0x3FF0000000000000
  EXPECT_EQ(bytes, "\xAB\x02\x01\x06\x05\x04\x03\0\0\0\0\0\0\xF0\x3F"sv);
}

TEST(Bytes, numbers_are_taken_as_they_were_put) {
  std::string bytes;
  put<std::uint64_t>(bytes, 0x0123456789ABCDEF);
  put<float>(bytes, -2.5F);
  put<std::uint8_t>(bytes, 255);
  ByteTaker taker(bytes);
  EXPECT_EQ(taker.take<std::uint64_t>(), 0x0123456789ABCDEF);
  EXPECT_EQ(taker.take<float>(), -2.5F);
  EXPECT_EQ(taker.take<std::uint8_t>(), 255);
  EXPECT_TRUE(taker.complete());
  EXPECT_TRUE(taker.rest().empty());
}

TEST(Bytes, a_take_beyond_the_end_is_zero_and_noticed) {
  ByteTaker taker("\x01\x02\x03");
  EXPECT_EQ(taker.take<std::uint32_t>(), 0U);
  EXPECT_FALSE(taker.complete());
  EXPECT_EQ(taker.take<std::uint8_t>(), 0) << "nothing is taken after a failed take";
  EXPECT_TRUE(taker.take_bytes(0).empty());
}

TEST(Bytes, a_huge_count_takes_nothing) {
  ByteTaker taker("abc");
  EXPECT_TRUE(taker.take_bytes(0xFFFFFFFFFFFFFFFF).empty());
  EXPECT_FALSE(taker.complete());
}

}  // namespace ribbon::bytes_test
