#include "geometry/object_axis.h"

#include <gtest/gtest.h>

#include "geometry/solids.h"
#include "geometry/winding_number.h"

namespace ribbon::object_axis_test {

const CentreAxis upright{{0, 0, 0}, {0, 1, 0}};

TriangleMesh moved(TriangleMesh mesh, const Eigen::Vector3f& way) {
  mesh.vertices.colwise() += way;
  return mesh;
}

TEST(WindingNumber, is_one_inside_and_none_outside) {
  const TriangleMesh mesh = closed(tube(0.1, -1, 2));
  EXPECT_NEAR(winding_number(mesh, {0.05, 1.9, 0}), 1, 1e-9);
  EXPECT_NEAR(winding_number(mesh, {0.05, 2.1, 0}), 0, 1e-9);
  EXPECT_NEAR(winding_number(mesh, {0.11, 0, 0}), 0, 1e-9);
  TriangleMesh inside_out = mesh;
  inside_out.triangles.row(0).swap(inside_out.triangles.row(1));
  EXPECT_NEAR(winding_number(inside_out, {0.05, 1.9, 0}), -1, 1e-9);
}

TEST(ObjectAxis, runs_from_end_to_end_of_a_post) {
  const auto axis = object_axis(upright, closed(tube(0.1, -1, 2))).value();
  EXPECT_EQ(axis.line, upright);
  EXPECT_NEAR(axis.extent().low_m, -1, 1e-6);
  EXPECT_NEAR(axis.extent().high_m, 2, 1e-6);
  EXPECT_TRUE(axis.is_inside(1.9));
  EXPECT_FALSE(axis.is_inside(2.1));
}

TEST(ObjectAxis, runs_through_an_object_whose_faces_are_inside_out) {
  TriangleMesh post = closed(tube(0.1, -1, 2));
  post.triangles.row(0).swap(post.triangles.row(1));
  EXPECT_NEAR(object_axis(upright, post).value().extent().high_m, 2, 1e-6);
}

TEST(ObjectAxis, runs_from_end_to_end_of_a_pipe_that_is_open) {
  const auto axis = object_axis(upright, tube(0.1, -1, 2)).value();
  EXPECT_NEAR(axis.extent().low_m, -1, 1e-3);
  EXPECT_NEAR(axis.extent().high_m, 2, 1e-3);
}

TEST(ObjectAxis, is_outside_between_two_parts_of_the_object) {
  const auto axis =
      object_axis(upright, together(closed(tube(0.1, -1, 2)), closed(tube(0.1, 3, 4)))).value();
  ASSERT_EQ(axis.inside.size(), 2U);
  EXPECT_FALSE(axis.is_inside(2.5));
  EXPECT_NEAR(axis.extent().high_m, 4, 1e-6);
}

TEST(ObjectAxis, goes_through_the_middle_of_an_object_beside_the_centre_axis) {
  const auto axis = object_axis(upright, moved(closed(tube(0.1, -1, 1)), {0.3F, 5, 0})).value();
  EXPECT_NEAR(axis.line.point_m.x(), 0.3, 1e-6);
  EXPECT_NEAR(axis.height_m({7, 5.5, 7}), 0.5, 1e-6);
  EXPECT_NEAR(axis.extent().low_m, -1, 1e-6);
}

TEST(ObjectAxis, there_is_none_without_an_axis_or_an_object) {
  EXPECT_FALSE(object_axis(std::nullopt, closed(tube(1, -1, 1))).has_value());
  EXPECT_FALSE(object_axis(upright, std::nullopt).has_value());
  EXPECT_FALSE(object_axis(upright, TriangleMesh{}).has_value());
}

}  // namespace ribbon::object_axis_test
