#include "verification/smallest_gap.h"

#include <gtest/gtest.h>

#include <limits>

#include "geometry/ribbon_grid.h"
#include "verification/feature_distance.h"
#include "verification/soups.h"

namespace ribbon::smallest_gap_test {

std::optional<SmallestGap> found_by_tree(const TriangleSoup& soup) {
  const BoxTree judged(soup, 0, soup.judged);
  const BoxTree rest(soup, soup.judged, static_cast<int>(soup.triangles.cols()));
  return smallest_gap(soup, FeatureOwners(soup.triangles), judged, rest);
}

bool share_a_vertex(const Eigen::VectorXi& a, const Eigen::VectorXi& b) {
  for (const int vertex : a)
    if ((b.array() == vertex).any()) return true;
  return false;
}

double corner_distance(const TriangleSoup& soup, int corner, int triangle) {
  return certain_point_triangle_distance(soup.points.col(corner), soup.corner(triangle, 0),
                                         soup.corner(triangle, 1), soup.corner(triangle, 2));
}

// Every corner and edge of one triangle against the other, again and again for shared ones.
double pair_gap(const TriangleSoup& soup, const TrianglePair& pair) {
  double gap = std::numeric_limits<double>::infinity();
  const Eigen::Vector3i t = soup.triangles.col(pair.first);
  const Eigen::Vector3i u = soup.triangles.col(pair.second);
  for (int i = 0; i < 3; ++i) {
    if (!share_a_vertex(t.segment(i, 1), u))
      gap = std::min(gap, corner_distance(soup, t[i], pair.second));
    if (!share_a_vertex(u.segment(i, 1), t))
      gap = std::min(gap, corner_distance(soup, u[i], pair.first));
    for (int j = 0; j < 3; ++j) {
      const Eigen::Vector2i e(t[i], t[(i + 1) % 3]);
      const Eigen::Vector2i f(u[j], u[(j + 1) % 3]);
      if (!share_a_vertex(e, f))
        gap =
            std::min(gap, certain_segments_distance(soup.points.col(e[0]), soup.points.col(e[1]),
                                                    soup.points.col(f[0]), soup.points.col(f[1])));
    }
  }
  return gap;
}

double brute_force_gap(const TriangleSoup& soup) {
  double gap = std::numeric_limits<double>::infinity();
  for_every_pair(soup,
                 [&](const TrianglePair& pair) { gap = std::min(gap, pair_gap(soup, pair)); });
  return gap;
}

TEST(SmallestGap, is_the_one_that_measuring_every_pair_finds) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    TriangleSoup soup = random_soup(seed, 60, 50, {-4000, 4000, 0.001F});
    soup.judged = 35;
    const auto gap = found_by_tree(soup).value();
    // The order of a segment's ends changes its rounding.
    EXPECT_NEAR(gap.certain_m, brute_force_gap(soup), 1e-12);
    EXPECT_NEAR(gap.certain_m, pair_gap(soup, gap.pair), 1e-12);
    EXPECT_LT(gap.pair.first, 35);
  }
}

TEST(SmallestGap, two_edges_come_nearest) {
  const auto soup =
      soup_of({{-2, 0, 0}, {2, 0, 0}, {0, 0, -5}, {0, -2, 0.25F}, {0, 2, 0.25F}, {0, 0, 5}},
              {{0, 1, 2}, {3, 4, 5}});
  EXPECT_NEAR(found_by_tree(soup)->certain_m, 0.25, 1e-13);
}

TEST(SmallestGap, neighbours_on_a_flat_ribbon_are_half_a_diagonal_apart) {
  // Quads 3 along and 4 across: a corner is 12 / 5 away from the diagonal that it faces.
  const RibbonGrid grid{4, 3};
  TriangleSoup soup{{3, grid.particle_count()}, grid.triangles(), grid.triangle_count()};
  for (int p = 0; p < grid.particle_count(); ++p)
    soup.points.col(p) << 3 * static_cast<float>(grid.row(p)), 0,
        4 * static_cast<float>(grid.column(p));
  EXPECT_NEAR(found_by_tree(soup)->certain_m, 2.4, 1e-13);
}

TEST(SmallestGap, a_folded_edge_brings_opposite_corners_together) {
  const auto soup =
      soup_of({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 1, 0.125F}}, {{0, 1, 2}, {1, 0, 3}});
  // From (1, 1, 0) to the plane z = y / 8.
  EXPECT_NEAR(found_by_tree(soup)->certain_m, 0.125 / std::sqrt(1 + 1.0 / 64), 1e-13);
}

TEST(SmallestGap, touching_is_a_gap_of_nothing) {
  const auto soup = soup_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {1, 2, 3}, {2, 1, 3}},
                            {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(found_by_tree(soup)->certain_m, 0);
}

TEST(SmallestGap, one_triangle_has_none) {
  EXPECT_FALSE(found_by_tree(soup_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}})));
}

}  // namespace ribbon::smallest_gap_test
