#include "verification/triangles_meet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "verification/soups.h"

namespace ribbon::triangles_meet_test {

using Eigen::Vector3f;

constexpr float tiniest = std::numeric_limits<float>::denorm_min();

// Two triangles without a common vertex: points 0 to 2 and 3 to 5.
bool strangers_meet(Points points) {
  return triangles_meet(soup_of(points, {{0, 1, 2}, {3, 4, 5}}), {0, 1});
}
// Common vertex 0: triangles 0 1 2 and 0 3 4.
bool corner_neighbours_meet(Points points) {
  return triangles_meet(soup_of(points, {{1, 2, 0}, {3, 0, 4}}), {0, 1});
}
// Common edge 0 1: triangles 0 1 2 and 0 1 3.
bool edge_neighbours_meet(Points points) {
  return triangles_meet(soup_of(points, {{2, 0, 1}, {1, 0, 3}}), {0, 1});
}

TEST(TrianglesMeet, an_edge_crosses_a_triangle) {
  EXPECT_TRUE(strangers_meet({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {9, 9, 1}}));
  EXPECT_FALSE(strangers_meet({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {3, 3, -1}, {3, 3, 1}, {9, 9, 1}}));
}

TEST(TrianglesMeet, planes_that_cross_elsewhere_do_not_count) {
  EXPECT_FALSE(strangers_meet({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1}, {2, 1, 1}, {9, 9, -1}}));
}

TEST(TrianglesMeet, a_corner_that_just_touches_a_face) {
  EXPECT_TRUE(strangers_meet({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {1, 2, 3}, {2, 1, 3}}));
  EXPECT_FALSE(
      strangers_meet({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, tiniest}, {1, 2, 3}, {2, 1, 3}}));
  EXPECT_TRUE(
      strangers_meet({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -tiniest}, {1, 2, 3}, {2, 1, 3}}));
}

TEST(TrianglesMeet, two_edges_that_just_touch) {
  const float above = std::nextafter(1.0F, 2.0F);
  EXPECT_TRUE(
      strangers_meet({{-2, 0, 1}, {2, 0, 1}, {0, 0, -5}, {0, -2, 1}, {0, 2, 1}, {0, 0, 5}}));
  EXPECT_FALSE(strangers_meet(
      {{-2, 0, 1}, {2, 0, 1}, {0, 0, -5}, {0, -2, above}, {0, 2, above}, {0, 0, 5}}));
}

TEST(TrianglesMeet, different_vertices_in_one_place_touch) {
  EXPECT_TRUE(strangers_meet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {-1, 0, 1}, {0, -1, 1}}));
  EXPECT_TRUE(corner_neighbours_meet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0.5F, -1, 1}}));
}

TEST(TrianglesMeet, coplanar_triangles_that_overlap_hold_each_other_or_lie_apart) {
  EXPECT_TRUE(strangers_meet({{0, 0, 1}, {4, 0, 1}, {0, 4, 1}, {1, 1, 1}, {5, 1, 1}, {1, 5, 1}}));
  EXPECT_TRUE(strangers_meet({{0, 0, 1}, {9, 0, 1}, {0, 9, 1}, {1, 1, 1}, {2, 1, 1}, {1, 2, 1}}));
  EXPECT_TRUE(strangers_meet({{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {0, 0, 1}, {9, 0, 1}, {0, 9, 1}}));
  EXPECT_FALSE(strangers_meet({{0, 0, 1}, {4, 0, 1}, {0, 4, 1}, {3, 3, 1}, {5, 3, 1}, {3, 5, 1}}));
  // In a slanted plane, one corner in the same position.
  EXPECT_TRUE(strangers_meet({{0, 0, 0}, {2, 1, 3}, {1, 2, 3}, {1, 0, 1}, {3, 1, 4}, {2, 1, 3}}));
}

TEST(TrianglesMeet, identical_triangles_meet) {
  EXPECT_TRUE(strangers_meet({{0, 0, 0}, {1, 0, 2}, {0, 1, 1}, {0, 0, 0}, {1, 0, 2}, {0, 1, 1}}));
  const auto twice = soup_of({{0, 0, 0}, {1, 0, 2}, {0, 1, 1}}, {{0, 1, 2}, {2, 0, 1}});
  EXPECT_TRUE(triangles_meet(twice, {0, 1}));
}

TEST(TrianglesMeet, corner_neighbours_may_share_their_corner_and_nothing_else) {
  EXPECT_FALSE(corner_neighbours_meet({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 1}}));
  // The opposite edge of one crosses the other.
  EXPECT_TRUE(corner_neighbours_meet({{0, 0, 0}, {4, -2, 0}, {4, 2, 0}, {2, 0, -1}, {2, 0, 1}}));
  EXPECT_TRUE(corner_neighbours_meet({{0, 0, 0}, {2, 0, -1}, {2, 0, 1}, {4, -2, 0}, {4, 2, 0}}));
  // The same beyond the other's opposite edge: now that edge is crossed.
  EXPECT_TRUE(corner_neighbours_meet({{0, 0, 0}, {4, -2, 0}, {4, 2, 0}, {9, 0, -1}, {9, 0, 1}}));
  // Coplanar: overlapping, side by side along a common ray, and just apart.
  EXPECT_TRUE(corner_neighbours_meet({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {4, 1, 0}, {4, 8, 0}}));
  EXPECT_TRUE(corner_neighbours_meet({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 2, 0}, {0, 8, 0}}));
  EXPECT_FALSE(corner_neighbours_meet(
      {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, std::nextafter(2.0F, 3.0F), 0}, {0, 8, 0}}));
}

TEST(TrianglesMeet, edge_neighbours_may_fold_but_not_onto_each_other) {
  EXPECT_FALSE(edge_neighbours_meet({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}}));
  EXPECT_FALSE(edge_neighbours_meet({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 1, tiniest}}));
  EXPECT_TRUE(edge_neighbours_meet({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 1, 0}}));
  EXPECT_TRUE(edge_neighbours_meet({{0, 0, 0}, {2, 0, 0}, {1, 3, 0}, {1, 1, 0}}));
  // Neither holds a corner of the other, but edges cross.
  EXPECT_TRUE(edge_neighbours_meet({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}}));
  EXPECT_TRUE(edge_neighbours_meet({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}));
}

TEST(TrianglesMeet, a_triangle_without_area_is_the_segment_that_is_left) {
  // A segment from (0, 0, -1) to (0, 0, 2) through and beside a face.
  EXPECT_TRUE(
      strangers_meet({{0, 0, 0}, {0, 0, 2}, {0, 0, -1}, {-1, -1, 1}, {3, -1, 1}, {-1, 3, 1}}));
  EXPECT_FALSE(strangers_meet({{0, 0, 0}, {0, 0, 2}, {0, 0, -1}, {1, 1, 1}, {3, 1, 1}, {1, 3, 1}}));
  // Two segments that cross, that are skew, that lie on one line.
  EXPECT_TRUE(strangers_meet({{0, 0, 0}, {0, 0, 2}, {0, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {3, 0, 1}}));
  EXPECT_FALSE(
      strangers_meet({{0, 0, 0}, {0, 0, 2}, {0, 0, -1}, {-1, 1, 1}, {1, 1, 1}, {3, 1, 1}}));
  EXPECT_TRUE(strangers_meet({{0, 0, 0}, {0, 0, 2}, {0, 0, -1}, {0, 0, 2}, {0, 0, 3}, {0, 0, 4}}));
  EXPECT_FALSE(strangers_meet({{0, 0, 0}, {0, 0, 2}, {0, 0, -1}, {0, 0, 3}, {0, 0, 5}, {0, 0, 4}}));
}

TEST(TrianglesMeet, a_triangle_without_extent_is_a_point) {
  const Vector3f p(1, 1, 0);
  EXPECT_TRUE(strangers_meet({p, p, p, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}));
  EXPECT_TRUE(strangers_meet({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, p, p, p}));
  EXPECT_FALSE(strangers_meet({p, p, p, {0, 0, 1}, {4, 0, 1}, {0, 4, 1}}));
  EXPECT_TRUE(strangers_meet({p, p, p, p, p, p}));
}

TEST(TrianglesMeet, neighbours_without_area_touch_with_what_lies_on_the_other) {
  // Vertex 2 lies on the common edge.
  EXPECT_TRUE(edge_neighbours_meet({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, -1, 0}}));
  // Vertex 1 lies on edge 0 2.
  EXPECT_TRUE(edge_neighbours_meet({{0, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, -1, 0}}));
  // The common corner lies on the opposite edge of one.
  EXPECT_TRUE(corner_neighbours_meet({{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 1}, {0, -1, 1}}));
  // It is the end of a segment.
  EXPECT_FALSE(corner_neighbours_meet({{0, 0, 0}, {-1, 0, 0}, {-2, 0, 0}, {1, 1, 1}, {1, -1, 1}}));
}

TEST(SegmentMeetsTriangle, hangs_together_with_its_ends) {
  const Vector3f a(0, 0, 0);
  const Vector3f b(4, 0, 0);
  const Vector3f c(0, 4, 0);
  EXPECT_TRUE(segment_meets_triangle({1, 1, 3}, {1, 1, 0}, a, b, c));
  EXPECT_FALSE(segment_meets_triangle({1, 1, 3}, {1, 1, tiniest}, a, b, c));
  EXPECT_TRUE(segment_meets_triangle({2, 2, 1}, {2, 2, -1}, a, b, c));  // on the border
  EXPECT_TRUE(segment_meets_triangle({4, 0, 1}, {4, 0, -1}, a, b, c));  // through a corner
  EXPECT_TRUE(segment_meets_triangle({1, 1, 0}, {1, 2, 0}, a, b, c));   // within
  EXPECT_TRUE(segment_meets_triangle({-1, 1, 0}, {9, 1, 0}, a, b, c));  // across, in its plane
  EXPECT_FALSE(segment_meets_triangle({5, 0, 0}, {9, 0, 0}, a, b, c));
}

// Exact transformations must not change any verdict.
class Transformed : public testing::TestWithParam<int> {
 protected:
  // Small whole coordinates: every special case is frequent, and transformations are exact.
  TriangleSoup soup_ = random_soup(static_cast<unsigned>(GetParam()), 9, 12, {-2, 2, 1});
  std::vector<TrianglePair> pairs_ = brute_force_pairs(soup_);

  // The soup with every point mapped.
  template <class Function>
  void expect_same(const Function& map) {
    TriangleSoup other = soup_;
    for (auto point : other.points.colwise()) point = map(Vector3f(point));
    EXPECT_EQ(brute_force_pairs(other), pairs_);
  }
};

TEST_P(Transformed, verdicts_do_not_depend_on_axes_mirrors_or_powers_of_two) {
  expect_same([](const Vector3f& p) { return Vector3f(p.y(), p.z(), p.x()); });
  expect_same([](const Vector3f& p) { return Vector3f(p.y(), p.x(), p.z()); });
  expect_same([](const Vector3f& p) { return Vector3f(-p.x(), p.y(), p.z()); });
  expect_same([](const Vector3f& p) { return Vector3f(p * 0x1p-120F); });
  expect_same([](const Vector3f& p) { return Vector3f(p * 0x1p+120F); });
  expect_same([](const Vector3f& p) { return Vector3f(p * tiniest); });
  expect_same(
      [](const Vector3f& p) { return Vector3f(p.x() * 0x1p+100F, p.y(), p.z() * tiniest); });
  expect_same([](const Vector3f& p) { return Vector3f(p.array() + 4096); });
  expect_same([](const Vector3f& p) {  // a shear
    return Vector3f(p.x() + 3 * p.y() - p.z(), p.y() + 5 * p.z(), p.z());
  });
}

TEST_P(Transformed, verdicts_do_not_depend_on_the_order_of_triangles_or_corners) {
  TriangleSoup other = soup_;
  for (auto triangle : other.triangles.colwise()) std::swap(triangle[0], triangle[2]);
  EXPECT_EQ(brute_force_pairs(other), pairs_);
  for (auto triangle : other.triangles.colwise()) std::swap(triangle[1], triangle[2]);
  EXPECT_EQ(brute_force_pairs(other), pairs_);
  for_every_pair(soup_, [&](const TrianglePair& pair) {
    EXPECT_EQ(triangles_meet(soup_, {pair.second, pair.first}), triangles_meet(soup_, pair));
  });
}

INSTANTIATE_TEST_SUITE_P(RandomSoups, Transformed, testing::Range(1, 25));

}  // namespace ribbon::triangles_meet_test
