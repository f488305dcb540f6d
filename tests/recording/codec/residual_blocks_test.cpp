#include "recording/codec/residual_blocks.h"

#include <gtest/gtest.h>

#include <bit>
#include <numeric>
#include <random>
#include <set>

#include "recording/codec/entropy_tables.h"

namespace ribbon::residual_blocks_test {

// Residuals whose size changes along the ribbon from all 0 to about `largest`.
Residuals growing_residuals(const PolyphasePlanes& planes, double largest) {
  std::mt19937 random(3);
  const RibbonGrid grid = planes.grid();
  Residuals residuals;
  for (auto& component : residuals) {
    component.resize(planes.cells());
    for (int i = 0; i < grid.along; ++i)
      for (int j = 0; j < grid.across; ++j)
        component[planes.cell_of(i, j)] = static_cast<std::uint32_t>(
            largest * i / grid.along * (static_cast<double>(random()) / 4294967296.0));
  }
  return residuals;
}

// Those of particles; what lies between them is nobody's.
Residuals of_particles(const Residuals& residuals, const PolyphasePlanes& planes) {
  Residuals result;
  for (std::size_t c = 0; c < 3; ++c)
    for (int i = 0; i < planes.grid().along; ++i)
      for (int j = 0; j < planes.grid().across; ++j)
        result[c].push_back(residuals[c].at(planes.cell_of(i, j)));
  return result;
}

TEST(ResidualBlocks, each_particle_lies_in_one_block) {
  for (const RibbonGrid grid : {RibbonGrid{2, 2}, {37, 5}, {400, 16}, {35, 12}}) {
    const PolyphasePlanes planes(grid);
    std::vector<int> blocks_of(planes.cells());
    for (const ResidualBlock& block : residual_blocks(planes)) {
      EXPECT_LE(block.particles(), 64U);
      for (std::size_t b = 0; b < block.columns; ++b)
        for (std::size_t k = 0; k < block.length; ++k)
          ++blocks_of.at(block.cell + b * planes.stride() + k);
    }
    for (int i = 0; i < grid.along; ++i)
      for (int j = 0; j < grid.across; ++j) EXPECT_EQ(blocks_of.at(planes.cell_of(i, j)), 1);
    EXPECT_EQ(std::accumulate(blocks_of.begin(), blocks_of.end(), 0), grid.particle_count());
  }
}

class ResidualBlocks : public testing::TestWithParam<double> {};

TEST_P(ResidualBlocks, residuals_come_back) {
  for (const RibbonGrid grid : {RibbonGrid{2, 2}, {37, 5}, {64, 16}})
    for (const auto& tables : {std::vector<std::string>(), standard_entropy_tables()}) {
      const PolyphasePlanes planes(grid);
      const Residuals residuals = growing_residuals(planes, GetParam());
      std::string bytes;
      ResidualPacker(planes, tables).append(residuals, bytes);
      Residuals unpacked;
      ASSERT_TRUE(ResidualUnpacker(planes, tables).unpack(bytes, unpacked));
      EXPECT_EQ(of_particles(unpacked, planes), of_particles(residuals, planes));
      EXPECT_FALSE(ResidualUnpacker(planes, tables).unpack(bytes + "x", unpacked));
      for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 50)
        EXPECT_FALSE(ResidualUnpacker(planes, tables).unpack(bytes.substr(0, size), unpacked));
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, ResidualBlocks,
                         testing::Values(0.0, 1.5, 3.0, 8.0, 40.0, 300.0, 1e5, 4294967295.0));

TEST_P(ResidualBlocks, runs_hold_no_other_symbols_than_are_told) {
  const PolyphasePlanes planes({64, 16});
  ResidualPacker packer(planes, {});
  std::string bytes;
  packer.append(growing_residuals(planes, GetParam()), bytes);
  for (std::size_t kind = 0; kind < symbol_kinds; ++kind) {
    const auto symbols = symbols_of(kind);
    const std::set<unsigned char> told(symbols.begin(), symbols.end());
    EXPECT_EQ(told.size(), symbols.size());
    for (const char symbol : packer.runs()[kind])
      EXPECT_TRUE(told.contains(static_cast<unsigned char>(symbol))) << kind;
  }
}

TEST(ResidualBlocks, a_single_large_residual_among_zeros_comes_back) {
  const PolyphasePlanes planes({64, 16});
  Residuals residuals = growing_residuals(planes, 0);
  residuals[1][planes.cell_of(50, 7)] = 0xFFFFFFFF;
  std::string bytes;
  ResidualPacker(planes, standard_entropy_tables()).append(residuals, bytes);
  Residuals unpacked;
  ASSERT_TRUE(ResidualUnpacker(planes, standard_entropy_tables()).unpack(bytes, unpacked));
  EXPECT_EQ(of_particles(unpacked, planes), of_particles(residuals, planes));
}

TEST(ResidualBlocks, nothing_but_zeros_takes_next_to_nothing) {
  const PolyphasePlanes planes({400, 16});
  std::string bytes;
  ResidualPacker(planes, standard_entropy_tables()).append(growing_residuals(planes, 0), bytes);
  EXPECT_LT(bytes.size(), 30U);
}

TEST(ResidualBlocks, entropy_tables_make_short_runs_shorter) {
  const PolyphasePlanes planes({64, 16});
  // Half as many of each residual as of the residual before, as where a prediction is good.
  Residuals residuals = growing_residuals(planes, 0);
  std::mt19937 random(5);
  for (auto& component : residuals)
    for (std::uint32_t& residual : component)
      residual = static_cast<std::uint32_t>(
          std::countr_zero(static_cast<std::uint32_t>(random()) | 0x8000U));
  std::string with;
  std::string without;
  ResidualPacker(planes, standard_entropy_tables()).append(residuals, with);
  ResidualPacker(planes, {}).append(residuals, without);
  EXPECT_LT(with.size(), without.size());
}

}  // namespace ribbon::residual_blocks_test
