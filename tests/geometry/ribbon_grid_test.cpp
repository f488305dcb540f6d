#include "geometry/ribbon_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace ribbon::ribbon_grid_test {

TEST(RibbonGrid, numbers_particles_row_by_row) {
  const RibbonGrid grid{4, 3};
  EXPECT_EQ(grid.particle_count(), 12);
  EXPECT_EQ(grid.particle(2, 1), 7);
  EXPECT_EQ(grid.row(7), 2);
  EXPECT_EQ(grid.column(7), 1);
}

TEST(RibbonGrid, triangles_cover_each_quad_once_and_share_one_orientation) {
  const RibbonGrid grid{5, 4};
  const Eigen::Matrix3Xi triangles = grid.triangles();
  ASSERT_EQ(triangles.cols(), 24);
  // In a consistently oriented surface no directed edge occurs twice.
  std::map<std::pair<int, int>, int> directed;
  for (int t = 0; t < triangles.cols(); ++t)
    for (int c = 0; c < 3; ++c) ++directed[{triangles(c, t), triangles((c + 1) % 3, t)}];
  int borders = 0;
  for (const auto& [edge, count] : directed) {
    EXPECT_EQ(count, 1);
    if (!directed.contains({edge.second, edge.first})) ++borders;
  }
  EXPECT_EQ(borders, 2 * (5 - 1) + 2 * (4 - 1));
}

TEST(RibbonGrid, both_triangles_of_a_quad_have_its_diagonal) {
  const RibbonGrid grid{5, 4};
  for (int q = 0; q < grid.quad_count(); ++q) {
    const auto [low, high] = grid.diagonal(q);
    EXPECT_LT(low, high);
    for (const int t : {2 * q, 2 * q + 1}) {
      const auto corners = grid.triangle(t);
      EXPECT_EQ(std::count(corners.begin(), corners.end(), low), 1);
      EXPECT_EQ(std::count(corners.begin(), corners.end(), high), 1);
    }
  }
}

TEST(RibbonGrid, finds_the_triangles_of_each_particle) {
  for (const RibbonGrid grid : {RibbonGrid{5, 4}, RibbonGrid{2, 2}, RibbonGrid{3, 7}}) {
    using Corners = std::array<int, 2>;  // the other two
    std::map<int, std::multiset<Corners>> expected;
    for (int t = 0; t < grid.triangle_count(); ++t) {
      const auto [a, b, c] = grid.triangle(t);
      expected[a].insert({std::min(b, c), std::max(b, c)});
      expected[b].insert({std::min(c, a), std::max(c, a)});
      expected[c].insert({std::min(a, b), std::max(a, b)});
    }
    for (int particle = 0; particle < grid.particle_count(); ++particle) {
      std::multiset<Corners> found;
      EXPECT_FALSE(grid.any_triangle_at(particle, [&](int b, int c) {
        found.insert({std::min(b, c), std::max(b, c)});
        return false;
      }));
      EXPECT_EQ(found, expected[particle]) << particle;
      EXPECT_TRUE(grid.any_triangle_at(particle, [&](int /*b*/, int /*c*/) { return true; }));
    }
  }
}

TEST(RibbonGrid, a_fan_splits_a_quad_into_its_two_triangles) {
  const RibbonGrid grid{5, 4};
  for (int q = 0; q < grid.quad_count(); ++q) {
    const auto [a, b, c, d] = grid.fan(q);
    // The same triangles, whichever comes first and wherever each begins.
    const auto turned = [](std::array<int, 3> t) {
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      return t;
    };
    EXPECT_EQ((std::set{turned({a, b, c}), turned({a, c, d})}),
              (std::set{turned(grid.triangle(2 * q)), turned(grid.triangle(2 * q + 1))}))
        << q;
  }
}

}  // namespace ribbon::ribbon_grid_test
