#include "obstacle/obstacle.h"

#include <gtest/gtest.h>

#include "files/files.h"

namespace ribbon::obstacle_test {

std::filesystem::path written(const std::string& name, const std::string& text) {
  auto file = std::filesystem::path(testing::TempDir()) / name;
  EXPECT_TRUE(write_file(file, text).has_value());
  return file;
}

ObstacleScene scene_of(const std::filesystem::path& file) {
  ObstacleScene scene;
  scene.file = file;
  return scene;
}

TEST(Obstacle, is_scaled_then_placed) {
  ObstacleScene scene = scene_of(written("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n"));
  scene.scale = 0.5;
  scene.position_m = {10, 0, -1};
  const TriangleMesh mesh = read_obstacle(scene).value();
  EXPECT_EQ(mesh.name, "triangle");
  ASSERT_EQ(mesh.triangles.cols(), 1);
  Eigen::Matrix3f corners;
  for (int c = 0; c < 3; ++c) corners.col(c) = mesh.vertices.col(mesh.triangles(c, 0));
  Eigen::Matrix3f expected;
  expected << 10, 10.5, 10, 0, 0, 1, -1, -1, -1;
  EXPECT_EQ(corners, expected);
}

TEST(Obstacle, corners_that_differ_only_in_uv_or_normal_are_joined) {
  const auto file = written("seam.obj",
                            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0\n"
                            "f 1/1 2/2 3/3\nf 1/4 3/2 4/1\n");
  EXPECT_EQ(read_obstacle(scene_of(file)).value().vertices.cols(), 4);
}

TEST(Obstacle, polygons_become_triangles_and_several_objects_one_mesh) {
  const auto file = written("two.obj",
                            "o square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"
                            "o triangle\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 5 6 7\n");
  const TriangleMesh mesh = read_obstacle(scene_of(file)).value();
  EXPECT_EQ(mesh.triangles.cols(), 3);
  EXPECT_EQ(mesh.vertices.cols(), 7);
  EXPECT_LT(mesh.triangles.maxCoeff(), 7);
}

TEST(Obstacle, other_formats_are_read_too) {
  const auto file = written("triangle.stl",
                            "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                            "vertex 0 1 0\nendloop\nendfacet\nendsolid t\n");
  EXPECT_EQ(read_obstacle(scene_of(file)).value().triangles.cols(), 1);
}

TEST(Obstacle, a_missing_file_and_a_file_without_faces_are_named) {
  const auto missing = read_obstacle(scene_of("/no/such/mesh.obj"));
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().place, "/no/such/mesh.obj");
  EXPECT_FALSE(read_obstacle(scene_of(written("points.obj", "v 0 0 0\nv 1 0 0\n"))).has_value());
}

TEST(Obstacle, triangles_without_area_duplicates_and_inverted_ones_are_kept) {
  const auto file = written("bad.obj",
                            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.5 0 0\nv 7 7 7\n"
                            "f 1 2 3\nf 1 2 3\nf 3 2 1\nf 1 4 2\nf 1 2 2\nf 3 3 3\n");
  const TriangleMesh mesh = read_obstacle(scene_of(file)).value();
  EXPECT_EQ(mesh.triangles.cols(), 6);
  EXPECT_TRUE((mesh.vertices.array() < 2).all());  // the vertex without a triangle is gone
}

TEST(Obstacle, a_coordinate_that_is_no_number_is_told_with_its_triangle) {
  const auto answer = read_obstacle(
      scene_of(written("nan.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 nan 1\nf 1 2 3\nf 1 2 4\n")));
  ASSERT_FALSE(answer.has_value());
  EXPECT_NE(answer.error().sentence().find("nan.obj: a coordinate of triangle 2 of 2"),
            std::string::npos)
      << answer.error().sentence();
}

TEST(Obstacle, coordinates_beyond_single_precision_are_refused) {
  ObstacleScene scene = scene_of(written("large.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  scene.scale = 1e39;
  EXPECT_FALSE(read_obstacle(scene).has_value());
}

}  // namespace ribbon::obstacle_test
