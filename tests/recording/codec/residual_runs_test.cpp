#include "recording/codec/residual_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>

namespace ribbon::residual_runs_test {

// Residuals of both signs whose size changes along the ribbon from all 0 to about `largest`.
Residuals growing_residuals(const RibbonGrid& grid, double largest) {
  std::mt19937 random(3);
  Residuals residuals(grid);
  for (std::size_t c = 0; c < 3; ++c)
    for (int j = 0; j < grid.across; ++j)
      for (int i = 0; i < grid.along; ++i)
        residuals.column(c, j)[i] = static_cast<std::int32_t>(
            largest * i / grid.along * (static_cast<double>(random()) / 2147483648.0 - 1));
  return residuals;
}

std::string packed(const Residuals& residuals) {
  std::string bytes;
  ResidualPacker().append(residuals, bytes);
  return bytes;
}

bool unpack(const std::string& bytes, Residuals& residuals) {
  ByteTaker taker(bytes);
  return ResidualUnpacker().unpack(taker, residuals);
}

class ResidualRuns : public testing::TestWithParam<double> {};

TEST_P(ResidualRuns, residuals_come_back) {
  for (const RibbonGrid grid : {RibbonGrid{2, 2}, {37, 5}, {64, 16}}) {
    const Residuals residuals = growing_residuals(grid, GetParam());
    const std::string bytes = packed(residuals);
    Residuals unpacked(grid);
    ASSERT_TRUE(unpack(bytes, unpacked));
    EXPECT_EQ(unpacked.numbers(), residuals.numbers());
    EXPECT_FALSE(unpack(bytes + "x", unpacked));
    for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 50)
      EXPECT_FALSE(unpack(bytes.substr(0, size), unpacked));
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, ResidualRuns,
                         testing::Values(0.0, 1.5, 2.0, 8.0, 40.0, 300.0, 1e5, 2147483647.0));

// The least and the largest of so many bits in two's complement, and one beyond each.
TEST(ResidualPacking, every_width_comes_back) {
  for (int width = 1; width <= 32; ++width)
    for (const int beyond : {0, 1}) {
      const std::int64_t half = std::int64_t{1} << (width - 1);
      const auto least = static_cast<std::int32_t>(
          std::max<std::int64_t>(-half - beyond, std::numeric_limits<std::int32_t>::min()));
      const auto largest = static_cast<std::int32_t>(
          std::min<std::int64_t>(half - 1 + beyond, std::numeric_limits<std::int32_t>::max()));
      Residuals residuals({64, 3});
      for (std::size_t k = 0; k < residuals.numbers().size(); k += 3)
        residuals.numbers()[k] = k % 2 == 0 ? least : largest;
      Residuals unpacked({64, 3});
      ASSERT_TRUE(unpack(packed(residuals), unpacked));
      EXPECT_EQ(unpacked.numbers(), residuals.numbers()) << width << " " << beyond;
    }
}

TEST(ResidualPacking, a_single_large_residual_among_zeros_comes_back) {
  Residuals residuals({64, 16});
  residuals.column(1, 7)[50] = std::numeric_limits<std::int32_t>::min();
  Residuals unpacked({64, 16});
  ASSERT_TRUE(unpack(packed(residuals), unpacked));
  EXPECT_EQ(unpacked.numbers(), residuals.numbers());
}

TEST(ResidualPacking, nothing_but_zeros_takes_next_to_nothing) {
  EXPECT_LT(packed(Residuals({400, 16})).size(), 30U);
}

// Three blocks in a byte and a half.
TEST(ResidualPacking, what_is_left_of_the_last_byte_of_modes_means_nothing) {
  Residuals unpacked({16, 3});
  unpacked.numbers().assign(unpacked.numbers().size(), 7);
  ASSERT_EQ(unpacked.block_count(), 9U);
  EXPECT_TRUE(unpack(std::string("\0\0\0\0\0\0\0\0\xF0", 9), unpacked));
  EXPECT_EQ(unpacked.numbers(), Residuals({16, 3}).numbers());
  EXPECT_FALSE(unpack(std::string("\0\0\0\0\0\0\0\0\x0F", 9), unpacked));
}

}  // namespace ribbon::residual_runs_test
