#include "verification/intersecting_pairs.h"

#include <gtest/gtest.h>

#include "verification/soups.h"

namespace ribbon::intersecting_pairs_test {

IntersectingPairs found_by_tree(const TriangleSoup& soup, std::size_t most = 1'000'000) {
  const BoxTree judged(soup, 0, soup.judged);
  const BoxTree rest(soup, soup.judged, static_cast<int>(soup.triangles.cols()));
  return intersecting_pairs(soup, judged, rest, most);
}

TEST(IntersectingPairs, the_tree_finds_what_testing_every_pair_finds) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const TriangleSoup soup = random_soup(seed, 60, 90, {-9, 9, 0.125F});
    const auto found = found_by_tree(soup);
    EXPECT_EQ(found.pairs, brute_force_pairs(soup));
    EXPECT_FALSE(found.pairs.empty());
    EXPECT_TRUE(found.all);
  }
}

TEST(IntersectingPairs, what_is_not_judged_is_not_tested_against_itself) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    TriangleSoup soup = random_soup(seed, 60, 90, {-9, 9, 0.125F});
    soup.judged = 30;
    const auto pairs = found_by_tree(soup).pairs;
    EXPECT_EQ(pairs, brute_force_pairs(soup));
    for (const TrianglePair& pair : pairs) EXPECT_LT(pair.first, 30);
  }
}

TEST(IntersectingPairs, boxes_that_only_touch_are_looked_into) {
  // A face of the box x <= 1 and a corner of the box x >= 1.
  const auto soup = soup_of({{1, 0, 0}, {1, 4, 0}, {1, 0, 4}, {1, 1, 1}, {2, 1, 1}, {2, 2, 1}},
                            {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(found_by_tree(soup).pairs, (std::vector<TrianglePair>{{0, 1}}));
}

TEST(IntersectingPairs, cloth_in_one_point_ends_at_the_limit) {
  TriangleSoup soup = random_soup(1, 300, 500, {});
  soup.points.setConstant(0.7F);
  const auto found = found_by_tree(soup, 1000);
  EXPECT_EQ(found.pairs.size(), 1000U);
  EXPECT_FALSE(found.all);
}

TEST(IntersectingPairs, a_limit_that_is_just_reached_is_no_early_end) {
  const auto soup = soup_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {2, 1, 1}, {1, 2, 1}},
                            {{0, 1, 2}, {3, 4, 5}});
  const auto found = found_by_tree(soup, 1);
  EXPECT_EQ(found.pairs.size(), 1U);
  EXPECT_TRUE(found.all);
}

TEST(IntersectingPairs, nothing_judged_means_nothing_found) {
  TriangleSoup soup = random_soup(3, 20, 30, {});
  soup.judged = 0;
  EXPECT_TRUE(found_by_tree(soup).pairs.empty());
}

}  // namespace ribbon::intersecting_pairs_test
