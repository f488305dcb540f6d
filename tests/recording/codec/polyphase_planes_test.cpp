#include "recording/codec/polyphase_planes.h"

#include <gtest/gtest.h>

#include <set>

namespace ribbon::polyphase_planes_test {

class Planes : public testing::TestWithParam<RibbonGrid> {};

TEST_P(Planes, every_particle_has_a_cell_of_its_own) {
  const PolyphasePlanes planes(GetParam());
  std::set<std::size_t> cells;
  for (int i = 0; i < GetParam().along; ++i)
    for (int j = 0; j < GetParam().across; ++j) {
      const std::size_t cell = planes.cell_of(i, j);
      EXPECT_LT(cell, planes.cells());
      EXPECT_TRUE(cells.insert(cell).second);
      EXPECT_EQ(cell, planes.cell(2 * (i % 2) + j % 2, i / 2, j / 2));
    }
}

TEST_P(Planes, together_they_hold_all_particles) {
  const PolyphasePlanes planes(GetParam());
  int particles = 0;
  for (int plane = 0; plane < PolyphasePlanes::count; ++plane)
    particles += planes.rows(plane) * planes.columns(plane);
  EXPECT_EQ(particles, GetParam().particle_count());
}

TEST_P(Planes, whole_vectors_of_a_column_end_before_the_next) {
  const PolyphasePlanes planes(GetParam());
  constexpr int quantum = PolyphasePlanes::lane_quantum;
  for (int plane = 0; plane < PolyphasePlanes::count; ++plane) {
    const int whole = (planes.rows(plane) + quantum - 1) / quantum * quantum;
    EXPECT_LE(whole, planes.stride());
    EXPECT_LE(planes.cell(plane, whole, planes.columns(plane)), planes.cells());
  }
}

TEST_P(Planes, neighbours_lie_at_constant_distances) {
  const PolyphasePlanes planes(GetParam());
  for (int i = 0; i < GetParam().along; ++i)
    for (int j = 0; j < GetParam().across; ++j)
      for (int di = -1; di <= 1; ++di)
        for (int dj = -1; dj <= 1; ++dj)
          EXPECT_EQ(static_cast<std::ptrdiff_t>(planes.cell_of(i + di, j + dj)),
                    static_cast<std::ptrdiff_t>(planes.cell_of(i, j)) +
                        planes.step(2 * (i % 2) + j % 2, di, dj));
}

INSTANTIATE_TEST_SUITE_P(Grids, Planes,
                         testing::Values(RibbonGrid{2, 2}, RibbonGrid{3, 2}, RibbonGrid{2, 3},
                                         RibbonGrid{40, 16}, RibbonGrid{41, 17}));

}  // namespace ribbon::polyphase_planes_test
