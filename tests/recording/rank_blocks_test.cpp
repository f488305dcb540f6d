#include "recording/rank_blocks.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "recording/entropy_tables.h"

namespace ribbon {
namespace {

// Ranks whose size changes along the ribbon from all 0 to about `largest`.
Ranks growing_ranks(const RibbonGrid& grid, double largest) {
  std::mt19937 random(3);
  Ranks ranks;
  for (auto& component : ranks) {
    component.resize(room_for_ranks(grid));
    const int count = grid.particle_count();
    for (int k = 0; k < count; ++k)
      component[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(
          largest * k / count * (static_cast<double>(random()) / 4294967296.0));
  }
  return ranks;
}

Ranks trimmed(Ranks ranks, const RibbonGrid& grid) {
  for (auto& component : ranks) component.resize(static_cast<std::size_t>(grid.particle_count()));
  return ranks;
}

class RankBlocks : public testing::TestWithParam<double> {};

TEST_P(RankBlocks, ranks_come_back) {
  for (const RibbonGrid grid : {RibbonGrid{2, 2}, {37, 5}, {64, 16}})
    for (const auto& tables : {std::vector<std::string>(), standard_entropy_tables()}) {
      const ParityPlanes planes(grid);
      const Ranks ranks = growing_ranks(grid, GetParam());
      std::string bytes;
      RankPacker(planes, tables).append(ranks, bytes);
      Ranks unpacked;
      ASSERT_TRUE(RankUnpacker(planes, tables).unpack(bytes, unpacked));
      EXPECT_EQ(trimmed(unpacked, grid), trimmed(ranks, grid));
      EXPECT_FALSE(RankUnpacker(planes, tables).unpack(bytes + "x", unpacked));
      for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 50)
        EXPECT_FALSE(RankUnpacker(planes, tables).unpack(bytes.substr(0, size), unpacked));
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, RankBlocks,
                         testing::Values(0.0, 1.5, 3.0, 8.0, 40.0, 300.0, 1e5, 4294967295.0));

TEST(RankBlocks, a_single_large_rank_among_zeros_comes_back) {
  const RibbonGrid grid{64, 16};
  const ParityPlanes planes(grid);
  Ranks ranks = growing_ranks(grid, 0);
  ranks[1][500] = 0xFFFFFFFF;
  std::string bytes;
  RankPacker(planes, standard_entropy_tables()).append(ranks, bytes);
  Ranks unpacked;
  ASSERT_TRUE(RankUnpacker(planes, standard_entropy_tables()).unpack(bytes, unpacked));
  EXPECT_EQ(trimmed(unpacked, grid), trimmed(ranks, grid));
}

TEST(RankBlocks, nothing_but_zeros_takes_next_to_nothing) {
  const RibbonGrid grid{400, 16};
  std::string bytes;
  RankPacker(ParityPlanes(grid), standard_entropy_tables()).append(growing_ranks(grid, 0), bytes);
  EXPECT_LT(bytes.size(), 30U);
}

TEST(RankBlocks, entropy_tables_make_short_runs_shorter) {
  const RibbonGrid grid{64, 16};
  // Half as many of each rank as of the rank before, as where a prediction is good.
  Ranks ranks = growing_ranks(grid, 0);
  std::mt19937 random(5);
  for (auto& component : ranks)
    for (std::uint32_t& rank : component)
      rank = static_cast<std::uint32_t>(
          std::countr_zero(static_cast<std::uint32_t>(random()) | 0x8000U));
  std::string with;
  std::string without;
  RankPacker(ParityPlanes(grid), standard_entropy_tables()).append(ranks, with);
  RankPacker(ParityPlanes(grid), {}).append(ranks, without);
  EXPECT_LT(with.size(), without.size());
}

}  // namespace
}  // namespace ribbon
