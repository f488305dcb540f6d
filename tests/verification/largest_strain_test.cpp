#include "verification/largest_strain.h"

#include <gtest/gtest.h>

namespace ribbon::largest_strain_test {

// 3 x 3 particles, quads 3 along and 4 across: size at rest 6 x 8.
constexpr RibbonGrid grid{3, 3};

Eigen::Matrix3Xf flat(float along, float across) {
  Eigen::Matrix3Xf positions(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p)
    positions.col(p) << along * static_cast<float>(grid.row(p)),
        across * static_cast<float>(grid.column(p)), 7;
  return positions;
}

LargestStrain strain_of(const Eigen::Matrix3Xf& positions) {
  return largest_strain(grid, 6, 8, {.along = true, .across = true, .diagonals = true}, positions);
}

TEST(LargestStrain, cloth_at_rest_has_none) {
  EXPECT_EQ(strain_of(flat(3, 4)).strain, 0);
}

TEST(LargestStrain, stretch_along_and_across_and_compression_count) {
  EXPECT_DOUBLE_EQ(strain_of(flat(4.5F, 4)).strain, 0.5);
  EXPECT_DOUBLE_EQ(strain_of(flat(3, 5)).strain, 0.25);
  EXPECT_DOUBLE_EQ(strain_of(flat(3, 2)).strain, 0.5);
}

TEST(LargestStrain, shear_counts_on_both_diagonals) {
  // Pushed along by 0.75 a row, the lengths of neighbours change less than those of diagonals.
  Eigen::Matrix3Xf positions = flat(3, 4);
  for (int p = 0; p < grid.particle_count(); ++p)
    positions(0, p) += 0.75F * static_cast<float>(grid.column(p));
  const double long_diagonal = std::hypot(3.75, 4) / 5 - 1;
  const double short_diagonal = 1 - std::hypot(2.25, 4) / 5;
  EXPECT_DOUBLE_EQ(strain_of(positions).strain, std::max(long_diagonal, short_diagonal));
  positions = flat(3, 4);
  for (int p = 0; p < grid.particle_count(); ++p)
    positions(0, p) -= 0.75F * static_cast<float>(grid.column(p));
  EXPECT_DOUBLE_EQ(strain_of(positions).strain, std::max(long_diagonal, short_diagonal));
}

TEST(LargestStrain, only_limited_edges_count) {
  const Eigen::Matrix3Xf stretched = flat(4.5F, 5);
  EXPECT_DOUBLE_EQ(largest_strain(grid, 6, 8, {.along = true}, stretched).strain, 0.5);
  EXPECT_DOUBLE_EQ(largest_strain(grid, 6, 8, {.across = true}, stretched).strain, 0.25);
  EXPECT_DOUBLE_EQ(largest_strain(grid, 6, 8, {.diagonals = true}, stretched).strain,
                   std::hypot(4.5, 5) / 5 - 1);
  EXPECT_EQ(largest_strain(grid, 6, 8, {}, stretched).strain, 0);
}

TEST(LargestStrain, names_the_particles) {
  Eigen::Matrix3Xf positions = flat(3, 4);
  positions.col(8) << 6, 14, 7;  // the last particle, 10 from its neighbour across instead of 4
  const LargestStrain largest = strain_of(positions);
  EXPECT_EQ(largest.first, 7);
  EXPECT_EQ(largest.second, 8);
  EXPECT_DOUBLE_EQ(largest.strain, 1.5);
}

}  // namespace ribbon::largest_strain_test
