#include "recording/codec/rank_blocks.h"

#include <gtest/gtest.h>

#include <bit>
#include <numeric>
#include <random>
#include <set>

#include "recording/codec/entropy_tables.h"

namespace ribbon::rank_blocks_test {

// Ranks whose size changes along the ribbon from all 0 to about `largest`.
Ranks growing_ranks(const ParityPlanes& planes, double largest) {
  std::mt19937 random(3);
  const RibbonGrid grid = planes.grid();
  Ranks ranks;
  for (auto& component : ranks) {
    component.resize(planes.cells());
    for (int i = 0; i < grid.along; ++i)
      for (int j = 0; j < grid.across; ++j)
        component[planes.cell_of(i, j)] = static_cast<std::uint32_t>(
            largest * i / grid.along * (static_cast<double>(random()) / 4294967296.0));
  }
  return ranks;
}

// Those of particles; what lies between them is nobody's.
Ranks of_particles(const Ranks& ranks, const ParityPlanes& planes) {
  Ranks result;
  for (std::size_t c = 0; c < 3; ++c)
    for (int i = 0; i < planes.grid().along; ++i)
      for (int j = 0; j < planes.grid().across; ++j)
        result[c].push_back(ranks[c].at(planes.cell_of(i, j)));
  return result;
}

TEST(RankBlocks, each_particle_lies_in_one_block) {
  for (const RibbonGrid grid : {RibbonGrid{2, 2}, {37, 5}, {400, 16}, {35, 12}}) {
    const ParityPlanes planes(grid);
    std::vector<int> blocks_of(planes.cells());
    for (const RankBlock& block : rank_blocks(planes)) {
      EXPECT_LE(block.particles(), 64U);
      for (std::size_t b = 0; b < block.columns; ++b)
        for (std::size_t k = 0; k < block.length; ++k)
          ++blocks_of.at(block.cell + b * static_cast<std::size_t>(planes.stride()) + k);
    }
    for (int i = 0; i < grid.along; ++i)
      for (int j = 0; j < grid.across; ++j) EXPECT_EQ(blocks_of.at(planes.cell_of(i, j)), 1);
    EXPECT_EQ(std::accumulate(blocks_of.begin(), blocks_of.end(), 0), grid.particle_count());
  }
}

class RankBlocks : public testing::TestWithParam<double> {};

TEST_P(RankBlocks, ranks_come_back) {
  for (const RibbonGrid grid : {RibbonGrid{2, 2}, {37, 5}, {64, 16}})
    for (const auto& tables : {std::vector<std::string>(), standard_entropy_tables()}) {
      const ParityPlanes planes(grid);
      const Ranks ranks = growing_ranks(planes, GetParam());
      std::string bytes;
      RankPacker(planes, tables).append(ranks, bytes);
      Ranks unpacked;
      ASSERT_TRUE(RankUnpacker(planes, tables).unpack(bytes, unpacked));
      EXPECT_EQ(of_particles(unpacked, planes), of_particles(ranks, planes));
      EXPECT_FALSE(RankUnpacker(planes, tables).unpack(bytes + "x", unpacked));
      for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 50)
        EXPECT_FALSE(RankUnpacker(planes, tables).unpack(bytes.substr(0, size), unpacked));
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, RankBlocks,
                         testing::Values(0.0, 1.5, 3.0, 8.0, 40.0, 300.0, 1e5, 4294967295.0));

TEST_P(RankBlocks, runs_hold_no_other_symbols_than_are_told) {
  const ParityPlanes planes({64, 16});
  RankPacker packer(planes, {});
  std::string bytes;
  packer.append(growing_ranks(planes, GetParam()), bytes);
  for (std::size_t kind = 0; kind < symbol_kinds; ++kind) {
    const auto symbols = symbols_of(kind);
    const std::set<unsigned char> told(symbols.begin(), symbols.end());
    EXPECT_EQ(told.size(), symbols.size());
    for (const char symbol : packer.runs()[kind])
      EXPECT_TRUE(told.contains(static_cast<unsigned char>(symbol))) << kind;
  }
}

TEST(RankBlocks, a_single_large_rank_among_zeros_comes_back) {
  const ParityPlanes planes({64, 16});
  Ranks ranks = growing_ranks(planes, 0);
  ranks[1][planes.cell_of(50, 7)] = 0xFFFFFFFF;
  std::string bytes;
  RankPacker(planes, standard_entropy_tables()).append(ranks, bytes);
  Ranks unpacked;
  ASSERT_TRUE(RankUnpacker(planes, standard_entropy_tables()).unpack(bytes, unpacked));
  EXPECT_EQ(of_particles(unpacked, planes), of_particles(ranks, planes));
}

TEST(RankBlocks, nothing_but_zeros_takes_next_to_nothing) {
  const ParityPlanes planes({400, 16});
  std::string bytes;
  RankPacker(planes, standard_entropy_tables()).append(growing_ranks(planes, 0), bytes);
  EXPECT_LT(bytes.size(), 30U);
}

TEST(RankBlocks, entropy_tables_make_short_runs_shorter) {
  const ParityPlanes planes({64, 16});
  // Half as many of each rank as of the rank before, as where a prediction is good.
  Ranks ranks = growing_ranks(planes, 0);
  std::mt19937 random(5);
  for (auto& component : ranks)
    for (std::uint32_t& rank : component)
      rank = static_cast<std::uint32_t>(
          std::countr_zero(static_cast<std::uint32_t>(random()) | 0x8000U));
  std::string with;
  std::string without;
  RankPacker(planes, standard_entropy_tables()).append(ranks, with);
  RankPacker(planes, {}).append(ranks, without);
  EXPECT_LT(with.size(), without.size());
}

}  // namespace ribbon::rank_blocks_test
