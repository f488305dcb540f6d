#include "simulation/detection/locally_closest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <vector>

#include "geometry/flat_ribbon.h"
#include "geometry/vectors.h"
#include "simulation/detection/closest_weights.h"

namespace ribbon::locally_closest_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Kind = FeaturePair::Kind;

// The ribbon's particle (i, j) at x = i, z = j, at a height of its own, and so an obstacle above or
// below it, which is made as another ribbon is.
struct Sheets {
  Sheets(const RibbonGrid& ribbon_grid, const RibbonGrid& obstacle_grid, double obstacle_y)
      : grid(ribbon_grid),
        positions(flat_ribbon(ribbon_grid)),
        bodies(ribbon_grid, ObstacleBody(obstacle_grid.triangles(), flat_ribbon(obstacle_grid))) {
    bodies.obstacle->vertices.row(1).setConstant(obstacle_y);
  }

  // Of the obstacle's vertex.
  [[nodiscard]] int number(int vertex) const { return grid.particle_count() + vertex; }
  [[nodiscard]] double distance_m(const FeaturePair& pair) const {
    const auto x = corners(pair, bodies.vertices(positions));
    return length_of(weighted_sum(x, closest_weights(pair.kind, x)));
  }
  [[nodiscard]] bool are_closest(const FeaturePair& pair) const {
    const VertexPositions vertices = bodies.vertices(positions);
    const auto x = corners(pair, vertices);
    const Vector4d weights = closest_weights(pair.kind, x);
    return are_locally_closest(pair, weights, weighted_sum(x, weights).normalized(), vertices,
                               bodies);
  }

  RibbonGrid grid;
  Matrix3Xd positions;
  Bodies bodies;
};

// A ribbon of one quad, particle 0 of which is put over the obstacle's 4 x 4 quads.
struct Over : Sheets {
  explicit Over(const Vector3d& place) : Sheets({2, 2}, obstacle_grid, 0) {
    positions.row(1).setConstant(100);
    positions.col(0) = place;
  }
  // Against the triangle of these particles of the obstacle's grid.
  [[nodiscard]] bool are_closest(const std::array<int, 3>& triangle) const {
    return Sheets::are_closest(
        {Kind::vertex_triangle,
         {0, number(triangle[0]), number(triangle[1]), number(triangle[2])}});
  }
  static constexpr RibbonGrid obstacle_grid{5, 5};
};

// Quad (1, 1) is split from (1, 1) to (2, 2).
const std::array<int, 3> front = {6, 11, 12};  // (1, 1), (2, 1), (2, 2)
const std::array<int, 3> back = {6, 12, 7};    // (1, 1), (2, 2), (1, 2)

TEST(LocallyClosest, of_a_flat_floor_is_the_triangle_beneath) {
  const Over over({1.7, 0.2, 1.4});
  EXPECT_TRUE(over.are_closest(front));
  EXPECT_FALSE(over.are_closest(back));  // the closest on their common edge
}

TEST(LocallyClosest, on_an_edge_of_a_flat_floor_are_both) {
  const Over over({1.5, 0.2, 1.5});
  EXPECT_TRUE(over.are_closest(front));
  EXPECT_TRUE(over.are_closest(back));
}

TEST(LocallyClosest, beyond_a_border_is_the_triangle_there) {
  const Over beside({2.4, 0.1, -0.3});
  EXPECT_TRUE(beside.are_closest({10, 15, 16}));  // (2, 0), (3, 0), (3, 1)
  EXPECT_FALSE(beside.are_closest({10, 16, 11}));
}

// The diagonal of quad (1, 1) is raised or lowered.
TEST(LocallyClosest, of_a_ridge_it_is_and_of_a_valley_it_is_not) {
  for (const double height : {0.5, -0.5}) {
    SCOPED_TRACE(height);
    Over over({1.7, 1, 1.3});
    over.bodies.obstacle->vertices(1, 6) = height;
    over.bodies.obstacle->vertices(1, 12) = height;
    if (height < 0) over.positions.col(0) = Vector3d(1.8, -0.15, 1.2);
    EXPECT_EQ(over.are_closest(back), height > 0);
  }
}

TEST(LocallyClosest, of_edges_are_those_that_cross) {
  Sheets sheets({2, 2}, {2, 2}, 0.1);
  // Ribbon's edge along at z = 0, turned to cross the obstacle's edge across at x = 0.
  sheets.positions.row(0).array() -= 0.5;
  sheets.positions.row(2).array() += 0.5;
  const FeaturePair crossing{Kind::edge_edge, {0, 2, sheets.number(0), sheets.number(1)}};
  EXPECT_TRUE(sheets.are_closest(crossing));
  const FeaturePair beside{Kind::edge_edge, {0, 2, sheets.number(2), sheets.number(3)}};
  EXPECT_FALSE(sheets.are_closest(beside));
}

// Two sheets of 2 x 1 quads, 0.1 m apart; the upper, turned by a right angle, crosses the middle of
// the lower. The middle edge of one is raised or lowered.
TEST(LocallyClosest, an_edge_of_the_obstacle_sticks_out_and_cloth_may_bend) {
  for (const bool of_obstacle : {true, false})
    for (const double height : {0.2, 0.0, -0.2}) {
      SCOPED_TRACE(testing::Message() << of_obstacle << " " << height);
      Sheets sheets({3, 2}, {3, 2}, -0.3);
      const Matrix3Xd flat = sheets.positions;
      sheets.positions.row(0) = flat.row(2).array() + 0.5;
      sheets.positions.row(2) = 1.5 - flat.row(0).array();
      Matrix3Xd& bent = of_obstacle ? sheets.bodies.obstacle->vertices : sheets.positions;
      bent.row(1).segment(2, 2).array() += height;
      const FeaturePair middles{Kind::edge_edge, {2, 3, sheets.number(2), sheets.number(3)}};
      EXPECT_EQ(sheets.are_closest(middles), !of_obstacle || height >= 0);
    }
}

// A vertex under the middle of a large triangle.
TEST(LocallyClosest, a_vertex_of_the_obstacle_sticks_out) {
  for (const double height : {0.2, 0.0, -0.2}) {
    SCOPED_TRACE(height);
    Sheets sheets({2, 2}, {5, 5}, -0.3);
    sheets.positions.row(0) = 20 * sheets.positions.row(0).array() - 5;
    sheets.positions.row(2) = 20 * sheets.positions.row(2).array() - 2;
    sheets.bodies.obstacle->vertices(1, 12) += height;
    const std::array<int, 3> above = sheets.grid.triangle(0);
    EXPECT_EQ(sheets.are_closest(
                  {Kind::vertex_triangle, {sheets.number(12), above[0], above[1], above[2]}}),
              height >= 0);
  }
}

std::vector<FeaturePair> all_pairs(const Sheets& sheets) {
  std::vector<FeaturePair> pairs;
  const CollisionSurface ribbon = collision_surface(sheets.grid.triangles());
  const CollisionSurface& obstacle = sheets.bodies.obstacle->surface;
  const int particles = sheets.grid.particle_count();
  for (int p = 0; p < particles; ++p)
    for (const auto& t : obstacle.triangles.colwise())
      pairs.push_back({Kind::vertex_triangle,
                       {p, sheets.number(t[0]), sheets.number(t[1]), sheets.number(t[2])}});
  for (int v = 0; v < sheets.bodies.obstacle->vertices.cols(); ++v)
    for (const auto& t : ribbon.triangles.colwise())
      pairs.push_back({Kind::vertex_triangle, {sheets.number(v), t[0], t[1], t[2]}});
  for (const auto& a : ribbon.edges)
    for (const auto& b : obstacle.edges)
      pairs.push_back({Kind::edge_edge, {a[0], a[1], sheets.number(b[0]), sheets.number(b[1])}});
  return pairs;
}

// However the two surfaces lie.
TEST(LocallyClosest, are_the_closest_of_all) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(-0.6, 0.6);
  for (int trial = 0; trial < 200; ++trial) {
    Sheets sheets({3, 3}, {4, 3}, 1.5);
    for (Matrix3Xd* vertices : {&sheets.positions, &sheets.bodies.obstacle->vertices})
      for (double& coordinate : vertices->reshaped()) coordinate += anywhere(random);
    const std::vector<FeaturePair> pairs = all_pairs(sheets);
    double least_m = std::numeric_limits<double>::infinity();
    for (const FeaturePair& pair : pairs) least_m = std::min(least_m, sheets.distance_m(pair));
    EXPECT_TRUE(std::any_of(pairs.begin(), pairs.end(), [&](const FeaturePair& pair) {
      return sheets.distance_m(pair) <= least_m + 1e-9 && sheets.are_closest(pair);
    })) << trial;
  }
}

}  // namespace ribbon::locally_closest_test
