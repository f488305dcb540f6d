#include "recording/codec/residual_runs.h"

#include <gtest/gtest.h>

#include <random>

namespace ribbon::residual_runs_test {

// Residuals whose size changes along the ribbon from all 0 to about `largest`.
Residuals growing_residuals(const RibbonGrid& grid, double largest) {
  std::mt19937 random(3);
  Residuals residuals(grid);
  for (std::size_t c = 0; c < 3; ++c)
    for (int j = 0; j < grid.across; ++j)
      for (int i = 0; i < grid.along; ++i)
        residuals.column(c, j)[i] = static_cast<std::uint32_t>(
            largest * i / grid.along * (static_cast<double>(random()) / 4294967296.0));
  return residuals;
}

std::string packed(const Residuals& residuals) {
  std::string bytes;
  ResidualPacker().append(residuals, bytes);
  return bytes;
}

class ResidualRuns : public testing::TestWithParam<double> {};

TEST_P(ResidualRuns, residuals_come_back) {
  for (const RibbonGrid grid : {RibbonGrid{2, 2}, {37, 5}, {64, 16}}) {
    const Residuals residuals = growing_residuals(grid, GetParam());
    const std::string bytes = packed(residuals);
    Residuals unpacked(grid);
    ASSERT_TRUE(ResidualUnpacker().unpack(bytes, unpacked));
    EXPECT_EQ(unpacked.numbers(), residuals.numbers());
    EXPECT_FALSE(ResidualUnpacker().unpack(bytes + "x", unpacked));
    for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 50)
      EXPECT_FALSE(ResidualUnpacker().unpack(bytes.substr(0, size), unpacked));
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, ResidualRuns,
                         testing::Values(0.0, 1.5, 3.0, 8.0, 40.0, 300.0, 1e5, 4294967295.0));

TEST(ResidualPacking, every_width_comes_back) {
  for (int width = 0; width <= 32; ++width) {
    Residuals residuals({64, 3});
    const auto largest = static_cast<std::uint32_t>((std::uint64_t{1} << width) - 1);
    for (std::size_t k = 0; k < residuals.numbers().size(); k += 3)
      residuals.numbers()[k] = largest - static_cast<std::uint32_t>(width > 8 ? k % 17 : 0);
    Residuals unpacked({64, 3});
    ASSERT_TRUE(ResidualUnpacker().unpack(packed(residuals), unpacked));
    EXPECT_EQ(unpacked.numbers(), residuals.numbers()) << width;
  }
}

TEST(ResidualPacking, a_single_large_residual_among_zeros_comes_back) {
  Residuals residuals({64, 16});
  residuals.column(1, 7)[50] = 0xFFFFFFFF;
  Residuals unpacked({64, 16});
  ASSERT_TRUE(ResidualUnpacker().unpack(packed(residuals), unpacked));
  EXPECT_EQ(unpacked.numbers(), residuals.numbers());
}

TEST(ResidualPacking, nothing_but_zeros_takes_next_to_nothing) {
  EXPECT_LT(packed(Residuals({400, 16})).size(), 30U);
}

TEST(ResidualPacking, a_mode_that_is_not_known_is_refused) {
  // 0: the modes of the six blocks follow as they are.
  Residuals unpacked({16, 2});
  EXPECT_FALSE(ResidualUnpacker().unpack(std::string("\0\0\0\0\0\0\x1C", 7), unpacked));
  EXPECT_TRUE(ResidualUnpacker().unpack(std::string("\0\0\0\0\0\0\0", 7), unpacked));
}

}  // namespace ribbon::residual_runs_test
