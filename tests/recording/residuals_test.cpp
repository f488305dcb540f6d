#include "recording/residuals.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <random>

namespace ribbon {
namespace {

const PaddedGrid grid(RibbonGrid{30, 5});

template <class Make>
Residuals make_residuals(Make make) {
  Residuals residuals;
  for (Field& plane : residuals) {
    plane.assign(grid.size(), 0);
    for (int i = 0; i < grid.along; ++i)
      for (int j = 0; j < grid.across; ++j) plane[grid.at(i, j)] = make();
  }
  return residuals;
}

std::string joined(const std::vector<std::string>& parts) {
  return std::accumulate(parts.begin(), parts.end(), std::string());
}

TEST(Residuals, small_and_large_ones_come_back) {
  std::mt19937 random(7);
  for (const int bits : {0, 1, 2, 4, 7, 10, 15, 20, 27, 31}) {
    const auto largest = static_cast<std::int32_t>((std::uint32_t{1} << bits) - 1);
    const Residuals residuals = make_residuals([&] {
      const auto number = static_cast<std::int32_t>(random() >> 1) & largest;
      return random() % 2 == 0 ? number : -number;
    });
    const Activity activity(grid);
    const std::string bytes = joined(pack_residuals(grid, activity, residuals));
    EXPECT_LE(bytes.size(), packed_residuals_limit(grid));
    Residuals read;
    ASSERT_TRUE(unpack_residuals(grid, activity, bytes, read)) << bits << " bits";
    EXPECT_EQ(read, residuals);
  }
}

TEST(Residuals, one_extreme_among_zeros_comes_back) {
  for (const std::int32_t extreme : {std::numeric_limits<std::int32_t>::min(),
                                     std::numeric_limits<std::int32_t>::max(), -2, 254, 16384}) {
    Residuals residuals = make_residuals([] { return 0; });
    residuals[1][grid.at(7, 3)] = extreme;
    const Activity activity(grid);
    Residuals read;
    ASSERT_TRUE(
        unpack_residuals(grid, activity, joined(pack_residuals(grid, activity, residuals)), read));
    EXPECT_EQ(read, residuals);
  }
}

TEST(Residuals, classes_that_differ_come_back) {
  Activity activity(grid);
  Residuals residuals = make_residuals([] { return 0; });
  residuals[0][grid.at(10, 2)] = -40;
  residuals[2][grid.at(29, 4)] = 3;
  activity.remember(residuals);
  Residuals read;
  ASSERT_TRUE(
      unpack_residuals(grid, activity, joined(pack_residuals(grid, activity, residuals)), read));
  EXPECT_EQ(read, residuals);
}

TEST(Residuals, every_cut_and_every_appended_byte_is_noticed) {
  std::mt19937 random(8);
  const Residuals residuals =
      make_residuals([&] { return static_cast<std::int32_t>(random() % 4096); });
  const Activity activity(grid);
  const std::string bytes = joined(pack_residuals(grid, activity, residuals));
  Residuals read;
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(unpack_residuals(grid, activity, bytes.substr(0, size), read)) << size;
  EXPECT_FALSE(unpack_residuals(grid, activity, bytes + "x", read));
}

}  // namespace
}  // namespace ribbon
