#include "verification/frame_verifier.h"

#include <gtest/gtest.h>

#include <limits>

#include "geometry/flat_ribbon.h"

namespace ribbon::frame_verifier_test {

constexpr RibbonGrid grid{5, 3};
constexpr double length_m = 4;
constexpr double width_m = 2;

// Its quads are 1 x 1.
const Eigen::Matrix3Xf flat = flat_ribbon(grid).cast<float>();

// One triangle in the plane x = 1.7, from `bottom` upwards, and the same once more beside it.
TriangleMesh two_blades(float bottom) {
  TriangleMesh mesh{"blades", Eigen::Matrix3Xf(3, 6), Eigen::Matrix3Xi(3, 2)};
  mesh.vertices << 1.7F, 1.7F, 1.7F, 1.7F, 1.7F, 1.7F,                 //
      bottom, bottom + 1, bottom + 1, bottom, bottom + 1, bottom + 1,  //
      0.6F, 0.5F, 0.7F, 0.6F, 0.5F, 0.7F;
  mesh.triangles << 0, 3, 1, 4, 2, 5;
  return mesh;
}

FrameVerdict verdict_on(const Eigen::Matrix3Xf& positions,
                        const std::optional<TriangleMesh>& obstacle = std::nullopt) {
  return FrameVerifier({grid, length_m, width_m}, obstacle).verify(positions);
}

TEST(FrameVerifier, a_flat_ribbon_is_in_order) {
  const FrameVerdict verdict = verdict_on(flat);
  EXPECT_TRUE(verdict.finite);
  EXPECT_TRUE(verdict.intersections.pairs.empty());
  EXPECT_NEAR(verdict.gap.certain_m, std::sqrt(0.5), 1e-13);
}

TEST(FrameVerifier, measures_the_strain_of_the_edges_that_are_named) {
  Eigen::Matrix3Xf sheared = flat;
  sheared.row(0) += 0.5F * flat.row(2);
  const auto strain_of = [&](const LimitedEdges& limited) {
    return FrameVerifier({grid, length_m, width_m}, std::nullopt, limited)
        .verify(sheared)
        .strain.strain;
  };
  EXPECT_EQ(strain_of({}), 0);
  EXPECT_NEAR(strain_of({.along = true}), 0, 1e-15);
  EXPECT_NEAR(strain_of({.along = true, .across = true}), std::sqrt(1.25) - 1, 1e-15);
  EXPECT_NEAR(strain_of({.diagonals = true}), std::sqrt(3.25 / 2) - 1, 1e-15);
}

TEST(FrameVerifier, a_ribbon_folded_onto_itself_is_found) {
  Eigen::Matrix3Xf positions = flat;
  for (int j = 0; j < grid.across; ++j) positions(0, grid.particle(4, j)) = 2.5F;
  const FrameVerdict verdict = verdict_on(positions);
  EXPECT_FALSE(verdict.intersections.pairs.empty());
  EXPECT_EQ(verdict.gap.certain_m, 0);
  const FrameVerifier verifier({grid, length_m, width_m}, std::nullopt);
  EXPECT_TRUE(verifier.intersects(positions));
  EXPECT_FALSE(verifier.intersects(flat));
}

TEST(FrameVerifier, what_an_obstacle_touches_is_named_and_the_obstacle_itself_is_not_judged) {
  // The tip at (1.7, 0, 0.6) is in row 1, column 0 of the quads, an odd one: beyond its diagonal
  // from corner 1 to corner 3.
  const FrameVerdict verdict = verdict_on(flat, two_blades(0));
  const int quad = 2;
  const int blade = grid.triangle_count();
  EXPECT_EQ(verdict.intersections.pairs,
            (std::vector<TrianglePair>{{2 * quad + 1, blade}, {2 * quad + 1, blade + 1}}));
}

TEST(FrameVerifier, the_gap_to_an_obstacle_counts) {
  const FrameVerdict verdict = verdict_on(flat, two_blades(0.0625F));
  EXPECT_TRUE(verdict.intersections.pairs.empty());
  EXPECT_NEAR(verdict.gap.certain_m, 0.0625, 1e-13);
  EXPECT_EQ(verdict.gap.pair.first, 5);
}

TEST(FrameVerifier, coordinates_that_are_no_numbers_never_pass) {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
        -std::numeric_limits<float>::infinity()}) {
    Eigen::Matrix3Xf positions = flat;
    positions(1, 7) = bad;
    EXPECT_FALSE(verdict_on(positions).finite);
  }
}

TEST(FrameVerifier, an_obstacle_without_area_is_tested_exactly) {
  TriangleMesh needle = two_blades(0);
  needle.vertices.row(2).setConstant(0.6F);  // segments from the cloth upwards
  EXPECT_EQ(verdict_on(flat, needle).intersections.pairs.size(), 2U);
  needle.vertices.row(1).array() += std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(verdict_on(flat, needle).intersections.pairs.size(), 0U);
  needle.triangles.setZero();  // a point, and three times the same corner
  needle.vertices(1, 0) = 0;
  EXPECT_EQ(verdict_on(flat, needle).intersections.pairs.size(), 2U);
}

}  // namespace ribbon::frame_verifier_test
