#include "recording/codec/particle_columns.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>

namespace ribbon::particle_columns_test {

class Columns : public testing::TestWithParam<RibbonGrid> {};

TEST_P(Columns, every_particle_and_every_neighbour_has_a_cell_of_its_own) {
  const ParticleColumns columns(GetParam());
  std::set<std::size_t> cells;
  for (int j = -1; j <= GetParam().across; ++j)
    for (int i = -1; i <= GetParam().along; ++i) {
      EXPECT_LT(columns.cell(i, j), columns.cells());
      EXPECT_TRUE(cells.insert(columns.cell(i, j)).second);
    }
}

TEST_P(Columns, each_begins_where_a_cache_line_does) {
  const ParticleColumns columns(GetParam());
  const Lines<float> values(columns.cells());
  for (int j = -1; j <= GetParam().across; ++j)
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(&values[columns.cell(0, j)]) % 64, 0U) << j;
}

TEST_P(Columns, neighbours_lie_at_constant_distances) {
  const ParticleColumns columns(GetParam());
  for (int i = 0; i < GetParam().along; ++i)
    for (int j = 0; j < GetParam().across; ++j) {
      EXPECT_EQ(columns.cell(i + 1, j), columns.cell(i, j) + 1);
      EXPECT_EQ(columns.cell(i, j + 1), columns.cell(i, j) + columns.stride());
    }
}

INSTANTIATE_TEST_SUITE_P(Grids, Columns,
                         testing::Values(RibbonGrid{2, 2}, RibbonGrid{3, 2}, RibbonGrid{2, 3},
                                         RibbonGrid{40, 16}, RibbonGrid{41, 17}));

}  // namespace ribbon::particle_columns_test
