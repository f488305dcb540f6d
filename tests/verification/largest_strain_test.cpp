#include "verification/largest_strain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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
  return largest_strain({grid, 6, 8}, {.along = true, .across = true, .diagonals = true},
                        positions);
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
  EXPECT_DOUBLE_EQ(largest_strain({grid, 6, 8}, {.along = true}, stretched).strain, 0.5);
  EXPECT_DOUBLE_EQ(largest_strain({grid, 6, 8}, {.across = true}, stretched).strain, 0.25);
  EXPECT_DOUBLE_EQ(largest_strain({grid, 6, 8}, {.diagonals = true}, stretched).strain,
                   std::hypot(4.5, 5) / 5 - 1);
  EXPECT_EQ(largest_strain({grid, 6, 8}, {}, stretched).strain, 0);
}

TEST(LargestStrain, names_the_particles) {
  Eigen::Matrix3Xf positions = flat(3, 4);
  positions.col(8) << 6, 14, 7;  // the last particle, 10 from its neighbour across instead of 4
  const LargestStrain largest = strain_of(positions);
  EXPECT_EQ(largest.first, 7);
  EXPECT_EQ(largest.second, 8);
  EXPECT_DOUBLE_EQ(largest.strain, 1.5);
}

TEST(ParticleStrains, cloth_stretched_by_five_percent_shows_five_percent) {
  for (const float strain : particle_strains({grid, 6, 8}, {.along = true}, flat(3.15F, 4)))
    EXPECT_NEAR(strain, 0.05, 1e-6);
}

TEST(ParticleStrains, of_the_edges_of_a_particle_the_worst_counts_and_only_limited_ones) {
  Eigen::Matrix3Xf positions = flat(3, 4);
  positions(0, 8) += 0.6F;  // the last particle, away from its neighbour along
  const auto along = particle_strains({grid, 6, 8}, {.along = true}, positions);
  for (int p = 0; p < grid.particle_count(); ++p)
    EXPECT_NEAR(along[p], p == 8 || p == 5 ? 0.2 : 0, 1e-6) << "particle " << p;
  const auto across = particle_strains({grid, 6, 8}, {.across = true}, positions);
  EXPECT_NEAR(across[7], std::hypot(0.6, 4) / 4 - 1, 1e-6);
  EXPECT_EQ(across[5], 0);
}

TEST(ParticleStrains, the_largest_is_the_largest_strain_of_the_frame) {
  Eigen::Matrix3Xf positions = flat(3.1F, 3.9F);
  positions.col(4) += Eigen::Vector3f(0.1F, -0.2F, 0.3F);
  const LimitedEdges all{.along = true, .across = true, .diagonals = true};
  const auto strains = particle_strains({grid, 6, 8}, all, positions);
  const LargestStrain largest = largest_strain({grid, 6, 8}, all, positions);
  EXPECT_EQ(*std::max_element(strains.begin(), strains.end()), static_cast<float>(largest.strain));
  EXPECT_EQ(strains[largest.first], static_cast<float>(largest.strain));
}

// By hand: of three rows 0.3 m apart, 0.8, 1.6 and 2.4 m wide. The middle column keeps its length.
TEST(LargestStrain, of_a_ribbon_with_a_profile_goes_by_its_rows) {
  const RestSize tapered{{3, 3}, 0.6, 1.6, {0.8, 1.6, 2.4}};
  Eigen::Matrix3Xf positions(3, 9);
  for (int p = 0; p < 9; ++p) positions.col(p) << tapered.place_m(p).cast<float>(), 0;
  EXPECT_LT(largest_strain(tapered, {true, true, true}, positions).strain, 1e-6);
  EXPECT_GT(largest_strain({{3, 3}, 0.6, 1.6}, {true, true, true}, positions).strain, 0.4);
  positions(1, 8) += 0.3F;  // the last edge across, 1.2 m at rest
  const LargestStrain stretched = largest_strain(tapered, {.across = true}, positions);
  EXPECT_NEAR(stretched.strain, 0.25, 1e-6);
  EXPECT_EQ(stretched.first + stretched.second, 7 + 8);
}

}  // namespace ribbon::largest_strain_test
