#include "verification/cgal_oracle.h"

#include <gtest/gtest.h>

#include "verification/frame_verifier.h"
#include "verification/soups.h"

namespace ribbon::cgal_oracle_test {

TEST(CgalOracle, finds_what_was_planted) {
  const auto crossing = soup_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {9, 9, 1}},
                                {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(cgal_intersecting_pairs(crossing), (std::vector<TrianglePair>{{0, 1}}));
  const auto apart = soup_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {3, 3, -1}, {3, 3, 1}, {9, 9, 1}},
                             {{0, 1, 2}, {3, 4, 5}});
  EXPECT_TRUE(cgal_intersecting_pairs(apart).empty());
}

// Small whole coordinates, where nearly everything touches, and finer and finer ones.
class RandomSoups : public testing::TestWithParam<Coordinates> {};

TEST_P(RandomSoups, both_oracles_agree_on_every_pair) {
  std::size_t met = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    TriangleSoup soup = random_soup(seed, 30, 60, GetParam());
    if (seed % 3 == 0) soup.judged = 20;
    const auto pairs = brute_force_pairs(soup);
    ASSERT_EQ(pairs, cgal_intersecting_pairs(soup)) << "seed " << seed;
    met += pairs.size();
  }
  EXPECT_GT(met, 100U);
}

INSTANTIATE_TEST_SUITE_P(Sizes, RandomSoups,
                         testing::Values(Coordinates{0, 1, 1}, Coordinates{-1, 1, 1},
                                         Coordinates{-2, 2, 0.1F}, Coordinates{-9, 9, 0x1p-140F},
                                         Coordinates{-9, 9, 0x1p-149F},
                                         Coordinates{-9, 9, 0x1p+120F},
                                         Coordinates{-20'000'000, 20'000'000, 1e-7F}));

// Points near one slanted plane, off it by rounding: what filters leave over.
TEST(RandomSoups, both_oracles_agree_on_nearly_flat_soups) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    TriangleSoup soup = random_soup(seed, 40, 60, {-1'000'000, 1'000'000, 1e-6F});
    soup.points.row(2) = (soup.points.row(0) + soup.points.row(1)) / 3.0F;
    const auto pairs = brute_force_pairs(soup);
    ASSERT_EQ(pairs, cgal_intersecting_pairs(soup)) << "seed " << seed;
    EXPECT_FALSE(pairs.empty());
  }
}

// A ribbon of whole numbers: neighbours fold onto each other, touch and cross.
TEST(RandomRibbons, all_oracles_agree) {
  const RibbonGrid grid{8, 4};
  const FrameVerifier verifier({grid, 1, 1}, std::nullopt);
  int compared = 0;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const TriangleSoup random = random_soup(seed, grid.particle_count(), 1, {-9, 9, 0.3F});
    const auto pairs = verifier.verify(random.points).intersections.pairs;
    ASSERT_EQ(pairs, cgal_intersecting_pairs(verifier.soup(random.points)));
    const auto meshed = cgal_self_intersections(grid, random.points);
    if (!meshed) continue;
    ASSERT_EQ(pairs, *meshed);
    ++compared;
  }
  EXPECT_GT(compared, 5);
}

}  // namespace ribbon::cgal_oracle_test
