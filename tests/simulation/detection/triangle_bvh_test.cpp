#include "simulation/detection/triangle_bvh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "geometry/flat_ribbon.h"
#include "geometry/ribbon_grid.h"
#include "parallel/any_threads.h"
#include "simulation/detection/book.h"
#include "simulation/detection/feature_pairs.h"
#include "simulation/detection/vertex_ranges.h"

namespace ribbon::triangle_bvh_test {

using Eigen::Matrix3Xd;

constexpr auto both = TriangleBvh::Spare::curvature_and_boxes;

// Boxes and curvatures over a step.
void refit(TriangleBvh& bvh, const Matrix3Xd& t0, const Matrix3Xd& t1, double margin_m) {
  bvh.refit(vertex_ranges(t0, t1), margin_m);
  bvh.refit_curvatures(t0, t1);
}

// A ribbon wound up like a spiral spring with `turns` turns; neighbouring turns are `pitch` apart.
Matrix3Xd spiral(const RibbonGrid& grid, double turns, double pitch) {
  Matrix3Xd positions(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p) {
    const double angle = 2 * std::numbers::pi * turns * grid.row(p) / (grid.along - 1);
    const double radius = 1 + pitch * angle / (2 * std::numbers::pi);
    positions.col(p) << radius * std::cos(angle), 0.1 * grid.column(p), radius * std::sin(angle);
  }
  return positions;
}

std::set<std::array<int, 2>> as_set(const std::vector<CandidatePair>& pairs) {
  std::set<std::array<int, 2>> result;
  for (const CandidatePair& pair : pairs) {
    const bool is_new = result.insert({std::min(pair.a, pair.b), std::max(pair.a, pair.b)}).second;
    EXPECT_TRUE(is_new) << "pair listed twice";
  }
  return result;
}

bool share_a_vertex(const CollisionSurface& surface, int a, int b) {
  for (const int v : surface.triangles.col(a))
    if ((surface.triangles.col(b).array() == v).any()) return true;
  return false;
}

Box box_of(const CollisionSurface& surface, const Matrix3Xd& x, int t, double margin_m) {
  Box box = Box::around(x.col(surface.triangles(0, t)));
  box.include(x.col(surface.triangles(1, t)));
  box.include(x.col(surface.triangles(2, t)));
  box.grow(margin_m);
  return box;
}

TEST(TriangleBvh, every_rank_groups_about_three_regions) {
  const RibbonGrid grid{60, 5};
  const CollisionSurface surface = collision_surface(grid.triangles());
  const TriangleBvh bvh(surface, spiral(grid, 0.5, 0.1));
  const int leaves = grid.triangle_count();
  // Groups of exactly three would need leaves/2 inner nodes in all; pairs would need leaves - 1.
  EXPECT_GT(bvh.node_count() - leaves, leaves / 3);
  EXPECT_LT(bvh.node_count() - leaves, leaves * 3 / 4);
}

TEST(TriangleBvh, a_flat_ribbon_has_no_pairs_to_test) {
  const RibbonGrid grid{60, 5};
  const Matrix3Xd flat = 0.1 * flat_ribbon(grid);
  const CollisionSurface surface = collision_surface(grid.triangles());
  TriangleBvh bvh(surface, flat);
  refit(bvh, flat, flat, 0.05);
  EXPECT_TRUE(bvh.pairs_within(both).empty());
}

TEST(TriangleBvh, finds_all_pairs_of_distant_triangles_whose_boxes_meet) {
  const RibbonGrid grid{150, 4};
  const CollisionSurface surface = collision_surface(grid.triangles());
  const Matrix3Xd x = spiral(grid, 3, 0.03);
  TriangleBvh bvh(surface, x);
  const double margin_m = 0.02;
  refit(bvh, x, x, margin_m);
  const auto found = as_set(bvh.pairs_within(both));
  int expected = 0;
  for (int a = 0; a < grid.triangle_count(); ++a)
    for (int b = a + 1; b < grid.triangle_count(); ++b) {
      const bool meet = box_of(surface, x, a, margin_m).meets(box_of(surface, x, b, margin_m));
      if (!meet) {
        EXPECT_FALSE(found.contains({a, b}));
        continue;
      }
      // Neighbours on the same gently curved piece are rightly spared; other turns are not.
      const int rows_apart = std::abs(a - b) / (2 * (grid.across - 1));
      if (rows_apart < 25) continue;
      ++expected;
      EXPECT_TRUE(found.contains({a, b})) << a << " " << b;
    }
  EXPECT_GT(expected, 100);
}

TEST(TriangleBvh, boxes_alone_also_see_a_band_that_lies_flat_over_itself) {
  // Two turns of a ramp: all normals point up, yet one turn lies above the other.
  const RibbonGrid grid{120, 3};
  Matrix3Xd ramp(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p) {
    const double angle = 4 * std::numbers::pi * grid.row(p) / (grid.along - 1);
    const double radius = 1 + 0.1 * grid.column(p);
    ramp.col(p) << radius * std::cos(angle), 1e-3 * angle, radius * std::sin(angle);
  }
  const CollisionSurface surface = collision_surface(grid.triangles());
  TriangleBvh bvh(surface, ramp);
  refit(bvh, ramp, ramp, 0.01);
  EXPECT_TRUE(bvh.pairs_within(both).empty());
  int found_across_turns = 0;
  for (const CandidatePair& pair : bvh.pairs_within(TriangleBvh::Spare::boxes))
    found_across_turns += std::abs(pair.a - pair.b) > grid.triangle_count() / 4 ? 1 : 0;
  EXPECT_GT(found_across_turns, 100);
}

TEST(TriangleBvh, boxes_cover_the_whole_way_of_a_step) {
  const RibbonGrid grid{40, 3};
  const CollisionSurface surface = collision_surface(grid.triangles());
  Matrix3Xd t0 = spiral(grid, 0.5, 0.1);
  Matrix3Xd t1 = t0;
  // The last rows fly across to the first ones and back out on the other side.
  for (int p = grid.particle(35, 0); p < grid.particle_count(); ++p) t1.col(p)[0] += 4;
  TriangleBvh bvh(surface, t0);
  refit(bvh, t0, t0, 0);
  const std::size_t still = bvh.pairs_within(both).size();
  refit(bvh, t0, t1, 0);
  EXPECT_GT(bvh.pairs_within(both).size(), still + 10);
}

void expect_pairs_as_by_brute_force(const CollisionSurface& first, const Matrix3Xd& x,
                                    const CollisionSurface& second, const Matrix3Xd& y) {
  std::set<std::array<int, 2>> expected;
  for (int a = 0; a < first.triangles.cols(); ++a)
    for (int b = 0; b < second.triangles.cols(); ++b)
      if (box_of(first, x, a, 0).meets(box_of(second, y, b, 0))) expected.insert({a, b});
  std::set<std::array<int, 2>> found;
  for (const CandidatePair& pair : TriangleBvh(first, x).pairs_with(TriangleBvh(second, y)))
    found.insert({pair.a, pair.b});
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(found, expected);
}

TEST(TriangleBvh, pairs_with_another_surface_equal_brute_force) {
  const RibbonGrid grid{50, 4};
  const CollisionSurface surface = collision_surface(grid.triangles());
  const Matrix3Xd x = spiral(grid, 1, 0.2);
  Matrix3Xd y = x;
  y.row(0).array() += 0.4;
  expect_pairs_as_by_brute_force(surface, x, surface, y);
}

// If all pairs of them were neighbours, this would take hours.
TEST(TriangleBvh, thousands_of_triangles_at_an_edge_are_grouped_as_others_are) {
  const RibbonGrid grid{10, 2};
  const CollisionSurface ribbon = collision_surface(grid.triangles());
  const Matrix3Xd across = 0.1 * flat_ribbon(grid);
  const int count = 5000;
  for (const int outer_corners : {count, 1}) {  // pages of a book; copies of one triangle
    SCOPED_TRACE(outer_corners);
    const Book book(count, outer_corners);
    const CollisionSurface surface = collision_surface(book.triangles);
    const TriangleBvh bvh(surface, book.vertices);
    EXPECT_LT(bvh.node_count() - count, count * 3 / 4);
    expect_pairs_as_by_brute_force(surface, book.vertices, ribbon, across);
  }
}

TEST(TriangleBvh, a_surface_of_separate_pieces_is_one_tree) {
  Eigen::Matrix3Xi triangles(3, 5);
  Matrix3Xd x(3, 15);
  for (int t = 0; t < 5; ++t) {
    const int first = 3 * t;
    const double height = 0.1 * t;
    triangles.col(t) << first, first + 1, first + 2;
    x.middleCols(first, 3) << 0, 1, 0, 0, 0, 1, height, height, height;
  }
  const CollisionSurface surface = collision_surface(triangles);
  TriangleBvh bvh(surface, x);
  refit(bvh, x, x, 0.06);
  EXPECT_EQ(bvh.pairs_within(both).size(), 4U);
}

TEST(TriangleBvh, lists_the_same_pairs_in_the_same_order_for_any_number_of_threads) {
  const RibbonGrid grid{300, 6};
  const CollisionSurface surface = collision_surface(grid.triangles());
  const Matrix3Xd x = spiral(grid, 6, 0.02);
  const auto listed = same_for_any_threads([&] {
    TriangleBvh bvh(surface, x);
    refit(bvh, x, x, 0.01);
    std::vector<int> flat;
    for (const CandidatePair& pair : bvh.pairs_within(both))
      flat.insert(flat.end(), {pair.a, pair.b});
    return flat;
  });
  EXPECT_FALSE(listed.empty());
}

std::vector<FeaturePair> pairs_of(const CollisionSurface& surface,
                                  const std::vector<CandidatePair>& pairs, const Matrix3Xd& x,
                                  double margin_m) {
  const std::vector<MovingBox> ranges = vertex_ranges(x, x);
  const RangedSurface ranged{surface, ranges};
  return feature_pairs(ranged, ranged, pairs, margin_m);
}

TEST(FeaturePairs, of_two_far_triangles_are_six_vertices_and_nine_edge_pairs) {
  Eigen::Matrix3Xi triangles(3, 2);
  triangles << 0, 3, 1, 4, 2, 5;
  Matrix3Xd x(3, 6);
  x << 0, 1, 0, 0, 1, 0,  //
      0, 0, 1, 0, 0, 1,   //
      0, 0, 0, 0.1, 0.1, 0.1;
  const CollisionSurface surface = collision_surface(triangles);
  const std::vector<CandidatePair> pair = {{0, 1}};
  const auto found = pairs_of(surface, pair, x, 0.2);
  int vertex_triangle = 0;
  for (const FeaturePair& f : found)
    vertex_triangle += f.kind == FeaturePair::Kind::vertex_triangle ? 1 : 0;
  EXPECT_EQ(vertex_triangle, 6);
  EXPECT_EQ(found.size() - static_cast<std::size_t>(vertex_triangle), 9U);
  EXPECT_TRUE(pairs_of(surface, pair, x, 0.05).empty());
}

TEST(FeaturePairs, features_that_share_a_vertex_are_left_out) {
  const RibbonGrid grid{3, 2};
  const CollisionSurface surface = collision_surface(grid.triangles());
  Matrix3Xd x = Matrix3Xd::Zero(3, 6);  // everything in one point: all boxes meet
  std::vector<CandidatePair> pairs;
  for (int a = 0; a < 4; ++a)
    for (int b = a + 1; b < 4; ++b) pairs.push_back({a, b});
  for (const FeaturePair& f : pairs_of(surface, pairs, x, 0.1))
    EXPECT_EQ(std::set<int>(f.vertices.begin(), f.vertices.end()).size(), 4U);
  EXPECT_TRUE(share_a_vertex(surface, 0, 1));
}

}  // namespace ribbon::triangle_bvh_test
