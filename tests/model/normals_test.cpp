#include "model/normals.h"

#include <gtest/gtest.h>

namespace ribbon::normals_test {

const Eigen::Vector3f up = Eigen::Vector3f::UnitY();

// A square in the plane of x and y, folded upwards along its diagonal by `height` at corner 3.
Eigen::Matrix3Xf square(float height) {
  Eigen::Matrix3Xf points(3, 4);
  points << 0, 1, 1, 0,  //
      0, 0, 1, 1,        //
      0, 0, 0, height;
  return points;
}

TEST(VertexNormals, point_to_the_side_from_which_faces_run_counter_clockwise) {
  const Eigen::MatrixXi quad = Eigen::Vector4i(0, 1, 2, 3);
  const Eigen::Matrix3Xf normals = vertex_normals(square(0), quad, up);
  for (const auto& normal : normals.colwise()) EXPECT_EQ(normal, Eigen::Vector3f::UnitZ());
}

TEST(VertexNormals, a_quad_is_the_two_triangles_of_its_fan) {
  Eigen::MatrixXi triangles(3, 2);
  triangles << 0, 0, 1, 2, 2, 3;
  const Eigen::MatrixXi quad = Eigen::Vector4i(0, 1, 2, 3);
  EXPECT_EQ(vertex_normals(square(1), quad, up), vertex_normals(square(1), triangles, up));
}

TEST(VertexNormals, where_no_face_has_an_area_they_are_as_asked) {
  const Eigen::MatrixXi triangle = Eigen::Vector3i(0, 1, 1);
  const Eigen::Matrix3Xf normals = vertex_normals(square(0), triangle, up);
  for (const auto& normal : normals.colwise()) EXPECT_EQ(normal, up);
}

}  // namespace ribbon::normals_test
