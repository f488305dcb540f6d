#include "geometry/lines_of_sight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/solids.h"

namespace ribbon::lines_of_sight_test {

// Looked at from above: right is x, below is z, towards the viewer is y.
LinesOfSight from_above(const TriangleMesh& mesh) {
  Eigen::Matrix3Xd seen(3, mesh.vertices.cols());
  for (Eigen::Index i = 0; i < seen.cols(); ++i) {
    const Eigen::Vector3d vertex = mesh.vertices.col(i).cast<double>();
    seen.col(i) << vertex.x(), vertex.z(), vertex.y();
  }
  return {seen, mesh.triangles};
}

// A hill of a grid of squares over [0, 1] x [0, 1].
float hill(double x, double z) {
  return static_cast<float>(x * (1 - x) + std::sin(3 * z));
}

TriangleMesh hilly(int squares) {
  TriangleMesh mesh;
  const int side = squares + 1;
  mesh.vertices.resize(3, Eigen::Index{side} * side);
  mesh.triangles.resize(3, Eigen::Index{2} * squares * squares);
  for (int i = 0; i < side * side; ++i) {
    const double x = static_cast<double>(i % side) / squares;
    const int row = i / side;
    const double z = static_cast<double>(row) / squares;
    mesh.vertices.col(i) << static_cast<float>(x), hill(x, z), static_cast<float>(z);
  }
  for (int s = 0; s < squares * squares; ++s) {
    const int corner = s / squares * side + s % squares;
    mesh.triangles.col(2L * s) << corner, corner + 1, corner + side;
    mesh.triangles.col(2L * s + 1) << corner + 1, corner + side + 1, corner + side;
  }
  return mesh;
}

TEST(LinesOfSight, go_from_the_bottom_to_the_top_of_what_they_pass) {
  const LinesOfSight lines = from_above(closed(tube(1, -2, 3)));
  const auto range = lines.through({0.1, -0.2});
  ASSERT_TRUE(range.has_value());
  EXPECT_DOUBLE_EQ(range->low, -2);
  EXPECT_DOUBLE_EQ(range->high, 3);
  EXPECT_FALSE(lines.through({0.9, 0.9}).has_value());
}

TEST(LinesOfSight, pass_through_an_open_tube) {
  EXPECT_FALSE(from_above(tube(1, -2, 3)).through({0, 0}).has_value());
}

TEST(LinesOfSight, hold_everything_between_several_bodies) {
  const auto range =
      from_above(together(closed(tube(1, 4, 5)), closed(tube(1, -2, -1)))).through({0, 0});
  ASSERT_TRUE(range.has_value());
  EXPECT_DOUBLE_EQ(range->low, -2);
  EXPECT_DOUBLE_EQ(range->high, 5);
}

TEST(LinesOfSight, miss_nothing_where_triangles_join) {
  constexpr int squares = 30;
  const LinesOfSight lines = from_above(hilly(squares));
  for (int i = 0; i <= 4 * squares; ++i)
    for (int k = 0; k <= 4 * squares; ++k)
      EXPECT_TRUE(lines.through({i / (4.0 * squares), k / (4.0 * squares)}).has_value());
}

TEST(LinesOfSight, find_the_height_of_the_surface_whatever_its_triangles) {
  const LinesOfSight lines = from_above(hilly(100));
  std::mt19937 random(3);
  for (int i = 0; i < 1000; ++i) {
    const double x = static_cast<double>(random()) / 4294967296.0;
    const double z = static_cast<double>(random()) / 4294967296.0;
    const auto range = lines.through({x, z});
    ASSERT_TRUE(range.has_value());
    EXPECT_NEAR(range->low, hill(x, z), 3e-4);
    EXPECT_EQ(range->low, range->high);
  }
}

TEST(LinesOfSight, of_nothing_meet_nothing) {
  EXPECT_FALSE(from_above({}).through({0, 0}).has_value());
}

}  // namespace ribbon::lines_of_sight_test
