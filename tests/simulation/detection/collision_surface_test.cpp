#include "simulation/detection/collision_surface.h"

#include <gtest/gtest.h>

namespace ribbon::collision_surface_test {

Eigen::Matrix3Xi triangles(const std::vector<std::array<int, 3>>& corners) {
  Eigen::Matrix3Xi result(3, static_cast<Eigen::Index>(corners.size()));
  for (std::size_t t = 0; t < corners.size(); ++t)
    result.col(static_cast<Eigen::Index>(t)) << corners[t][0], corners[t][1], corners[t][2];
  return result;
}

using Edges = std::vector<std::array<int, 2>>;
using TriangleEdges = std::vector<std::array<int, 3>>;

// By hand: two triangles on either side of the edge between 5 and 7.
TEST(CollisionSurface, numbers_edges_in_the_order_of_the_triangles) {
  const CollisionSurface surface = collision_surface(triangles({{7, 5, 6}, {5, 7, 4}}));
  EXPECT_EQ(surface.edges, (Edges{{5, 7}, {5, 6}, {6, 7}, {4, 7}, {4, 5}}));
  EXPECT_EQ(surface.triangle_edges, (TriangleEdges{{0, 1, 2}, {0, 3, 4}}));
}

TEST(CollisionSurface, the_first_triangle_answers_for_what_it_shares) {
  const CollisionSurface surface = collision_surface(triangles({{7, 5, 6}, {5, 7, 4}}));
  for (int corner = 0; corner < 3; ++corner) {
    EXPECT_TRUE(surface.answers_for_vertex(0, corner));
    EXPECT_TRUE(surface.answers_for_edge(0, corner));
    EXPECT_EQ(surface.answers_for_vertex(1, corner), corner == 2);
    EXPECT_EQ(surface.answers_for_edge(1, corner), corner != 0);
  }
}

// Bad meshes are taken as they are: the third triangle lies on the first, the second is an edge.
TEST(CollisionSurface, triangles_may_lie_on_each_other_and_be_edges) {
  const CollisionSurface surface = collision_surface(triangles({{0, 1, 2}, {2, 2, 1}, {1, 0, 2}}));
  EXPECT_EQ(surface.edges, (Edges{{0, 1}, {1, 2}, {0, 2}, {2, 2}}));
  EXPECT_EQ(surface.triangle_edges, (TriangleEdges{{0, 1, 2}, {3, 1, 1}, {0, 2, 1}}));
  EXPECT_TRUE(surface.answers_for_edge(1, 0));
  EXPECT_FALSE(surface.answers_for_edge(1, 1));
  for (int corner = 0; corner < 3; ++corner) EXPECT_FALSE(surface.answers_for_vertex(2, corner));
}

// By hand: vertex 3 lies where 1 does, 4 and 5 where 0 does. The last triangle would lose a side.
TEST(CollisionSurface, vertices_at_equal_places_are_joined) {
  Eigen::Matrix3Xd vertices(3, 7);
  vertices << 0, 1, 0, 1, 0, -0.0, 5,  //
      0, 0, 1, 0, 0, 0, 0,             //
      0, 0, 0, 0, 0, 0, 0;
  EXPECT_EQ(with_equal_vertices_joined(triangles({{0, 1, 2}, {3, 4, 6}, {0, 5, 6}}), vertices),
            triangles({{0, 1, 2}, {1, 0, 6}, {0, 5, 6}}));
}

}  // namespace ribbon::collision_surface_test
