#include "simulation/contact/collision.h"

#include <gtest/gtest.h>

namespace ribbon::collision_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Kind = FeaturePair::Kind;

const FeaturePair vertex_triangle{Kind::vertex_triangle, {0, 1, 2, 3}};
const FeaturePair edge_edge{Kind::edge_edge, {0, 1, 2, 3}};

// A vertex at height y over the triangle (0,0,0), (4,0,0), (0,0,4), at x = 1, z = 1.
Matrix3Xd vertex_over_triangle(double y) {
  Matrix3Xd x(3, 4);
  x << 1, 0, 4, 0,  //
      y, 0, 0, 0,   //
      1, 0, 0, 4;
  return x;
}

// An edge along x at height y over an edge along z; they cross in plan at (1, 1).
Matrix3Xd edge_over_edge(double y) {
  Matrix3Xd x(3, 4);
  x << 0, 4, 1, 1,  //
      y, y, 0, 0,   //
      1, 1, 0, 2;
  return x;
}

TEST(Collision, a_vertex_that_passes_through_a_triangle_is_found_with_its_weights) {
  const auto collision =
      find_collision(vertex_triangle, vertex_over_triangle(1), vertex_over_triangle(-3), 0.1)
          .value();
  EXPECT_TRUE(collision.weights.isApprox(Vector4d(1, -0.5, -0.25, -0.25)));
  EXPECT_TRUE(collision.normal.isApprox(Vector3d::UnitY()));
}

TEST(Collision, an_edge_that_passes_through_an_edge_is_found_with_its_weights) {
  const auto collision =
      find_collision(edge_edge, edge_over_edge(1), edge_over_edge(-1), 0.1).value();
  EXPECT_TRUE(collision.weights.isApprox(Vector4d(0.75, 0.25, -0.5, -0.5)));
  EXPECT_TRUE(collision.normal.isApprox(Vector3d::UnitY()));
}

TEST(Collision, the_normal_points_back_to_the_side_of_the_start) {
  EXPECT_TRUE(
      find_collision(vertex_triangle, vertex_over_triangle(-1), vertex_over_triangle(1), 0.1)
          ->normal.isApprox(-Vector3d::UnitY()));
  EXPECT_TRUE(find_collision(edge_edge, edge_over_edge(-1), edge_over_edge(1), 0.1)
                  ->normal.isApprox(-Vector3d::UnitY()));
}

TEST(Collision, passing_beside_is_none) {
  Matrix3Xd before = vertex_over_triangle(1);
  Matrix3Xd after = vertex_over_triangle(-1);
  before(0, 0) = after(0, 0) = 5;
  EXPECT_FALSE(find_collision(vertex_triangle, before, after, 0.1).has_value());
  before = edge_over_edge(1);
  after = edge_over_edge(-1);
  before.row(2).head(2).setConstant(3);
  after.row(2).head(2).setConstant(3);
  EXPECT_FALSE(find_collision(edge_edge, before, after, 0.1).has_value());
}

TEST(Collision, ending_closer_than_the_gap_is_one_and_at_the_gap_none) {
  EXPECT_TRUE(
      find_collision(vertex_triangle, vertex_over_triangle(1), vertex_over_triangle(0.09), 0.1)
          .has_value());
  EXPECT_FALSE(
      find_collision(vertex_triangle, vertex_over_triangle(1), vertex_over_triangle(0.11), 0.1)
          .has_value());
  EXPECT_TRUE(find_collision(edge_edge, edge_over_edge(1), edge_over_edge(0.09), 0.1).has_value());
  EXPECT_FALSE(find_collision(edge_edge, edge_over_edge(1), edge_over_edge(0.11), 0.1).has_value());
}

TEST(Collision, a_moving_triangle_meets_a_still_vertex) {
  Matrix3Xd after = vertex_over_triangle(1);
  after.row(1).tail(3).setConstant(2);
  EXPECT_TRUE(find_collision(vertex_triangle, vertex_over_triangle(1), after, 0.1)
                  ->normal.isApprox(Vector3d::UnitY()));
}

}  // namespace ribbon::collision_test
