#include "simulation/published/strain_correction.h"

#include <gtest/gtest.h>

#include "geometry/flat_ribbon.h"

namespace ribbon::strain_correction_test {

using Eigen::Matrix3Xd;

TEST(PublishedStrainCorrection, leaves_a_ribbon_within_the_limit_alone) {
  const RibbonGrid grid{5, 3};
  PublishedStrainCorrection correction({grid, 4, 2}, 0.1);
  Matrix3Xd positions = 1.09 * flat_ribbon(grid);
  EXPECT_FALSE(correction.any_over_limit(positions));
  correction.apply(positions);
  EXPECT_EQ(positions, 1.09 * flat_ribbon(grid));
}

TEST(PublishedStrainCorrection, brings_a_stretched_pair_together_about_its_centre) {
  // Two rows 2 m apart at rest length 1: brought to 1.095, each particle moves
  // 0.4525 toward the other.
  const RibbonGrid grid{2, 2};
  PublishedStrainCorrection correction({grid, 1, 1}, 0.1);
  Matrix3Xd positions = flat_ribbon(grid);
  positions.row(0) *= 2;
  EXPECT_TRUE(correction.any_over_limit(positions));
  correction.apply(positions);
  EXPECT_NEAR(positions(0, 0), 0.4525, 1e-12);
  EXPECT_NEAR(positions(0, 2), 1.5475, 1e-12);
  EXPECT_NEAR(positions(2, 0), 0, 1e-12);
}

TEST(PublishedStrainCorrection, pushes_a_shrunk_pair_apart) {
  const RibbonGrid grid{2, 2};
  PublishedStrainCorrection correction({grid, 1, 1}, 0.1);
  Matrix3Xd positions = flat_ribbon(grid);
  positions.row(0) *= 0.5;
  correction.apply(positions);
  EXPECT_NEAR(positions(0, 2) - positions(0, 0), 0.905, 1e-12);
}

TEST(PublishedStrainCorrection, moves_particles_along_the_smoothed_surface_not_off_it) {
  // One particle of a flat ribbon is lifted a little: its stretched edges are shortened in the
  // plane.
  const RibbonGrid grid{21, 3};
  PublishedStrainCorrection correction({grid, 20, 2}, 0.01);
  Matrix3Xd positions = flat_ribbon(grid);
  positions(1, grid.particle(10, 1)) = 0.3;
  Matrix3Xd corrected = positions;
  correction.apply(corrected);
  const Matrix3Xd moved = corrected - positions;
  EXPECT_GT(moved.row(0).cwiseAbs().maxCoeff(), 0.01);
  EXPECT_LT(moved.middleCols(grid.particle(8, 0), 15).row(1).cwiseAbs().maxCoeff(),
            0.3 * moved.row(0).cwiseAbs().maxCoeff());
}

TEST(PublishedStrainCorrection, repeated_it_brings_every_edge_within_the_limit) {
  const RibbonGrid grid{12, 4};
  PublishedStrainCorrection correction({grid, 11, 3}, 0.1);
  Matrix3Xd positions = 1.4 * flat_ribbon(grid);
  int rounds = 0;
  while (correction.any_over_limit(positions) && rounds < 500) {
    correction.apply(positions);
    ++rounds;
  }
  EXPECT_LT(rounds, 500);
}

}  // namespace ribbon::strain_correction_test
