#include "simulation/start/inside_obstacle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "result/refusal.h"
#include "simulation/fastening_processor.h"
#include "simulation/loop_scene.h"

namespace ribbon::inside_obstacle_test {

// A ring of square cross-section round the y axis, closed.
TriangleMesh torus(double inner_m, double outer_m, double height_m, int sides = 24) {
  TriangleMesh mesh;
  mesh.name = "torus";
  mesh.vertices.resize(3, 4L * sides);
  mesh.triangles.resize(3, 8L * sides);
  for (int s = 0; s < sides; ++s) {
    const double angle = 2 * std::numbers::pi * s / sides;
    for (int corner = 0; corner < 4; ++corner) {
      const double radius_m = corner == 0 || corner == 3 ? inner_m : outer_m;
      mesh.vertices.col(4L * s + corner) << static_cast<float>(radius_m * std::sin(angle)),
          static_cast<float>(corner < 2 ? -height_m / 2 : height_m / 2),
          static_cast<float>(radius_m * std::cos(angle));
      const int here = 4 * s + corner;
      const int above = 4 * s + (corner + 1) % 4;
      const int next = 4 * ((s + 1) % sides) + corner;
      const int next_above = 4 * ((s + 1) % sides) + (corner + 1) % 4;
      mesh.triangles.col(2L * here) << here, next, next_above;
      mesh.triangles.col(2L * here + 1) << here, next_above, above;
    }
  }
  return mesh;
}

TriangleMesh with_repeated_corners(const TriangleMesh& mesh) {
  TriangleMesh apart;
  apart.vertices.resize(3, mesh.triangles.size());
  apart.triangles.resize(3, mesh.triangles.cols());
  for (int i = 0; i < mesh.triangles.size(); ++i) {
    apart.vertices.col(i) = mesh.vertices.col(mesh.triangles.reshaped()[i]);
    apart.triangles.reshaped()[i] = i;
  }
  return apart;
}

std::string refusal(const TriangleMesh& obstacle, ContactMethod contact = ContactMethod::gate) {
  Scene scene = scene_of_loop();
  scene.contact = contact;
  return refusal_of(FasteningProcessor::create(scene, mesh_of_loop(scene), obstacle));
}

TriangleMesh box(double half_m) {
  TriangleMesh mesh = closed(tube(half_m * std::numbers::sqrt2, -half_m, half_m, 4));
  mesh.name = "box";
  return mesh;
}

TriangleMesh without_a_triangle(TriangleMesh mesh) {
  mesh.triangles = mesh.triangles.rightCols(mesh.triangles.cols() - 1).eval();
  return mesh;
}

TriangleMesh with_some_inside_out(TriangleMesh mesh) {
  for (int t = 0; t < mesh.triangles.cols(); t += 2)
    std::swap(mesh.triangles(0, t), mesh.triangles(1, t));
  return mesh;
}

TriangleMesh with_a_triangle_twice(TriangleMesh mesh) {
  const Eigen::Index count = mesh.triangles.cols();
  mesh.triangles.conservativeResize(3, count + 1);
  mesh.triangles.col(count) = mesh.triangles.col(0);
  return mesh;
}

TriangleMesh moved(TriangleMesh mesh, float x_m) {
  mesh.vertices.row(0).array() += x_m;
  return mesh;
}

TEST(InsideObstacle, a_mesh_is_a_closed_body_where_no_edge_is_left_over) {
  EXPECT_EQ(closed_bodies(post(0.3)).size(), 0U);
  EXPECT_EQ(closed_bodies(without_a_triangle(torus(0.3, 0.4, 0.2))).size(), 0U);
  for (const TriangleMesh& mesh : {closed(post(0.3)), torus(0.3, 0.4, 0.2), box(1)})
    for (const TriangleMesh& bad : {mesh, with_repeated_corners(mesh), with_some_inside_out(mesh),
                                    with_a_triangle_twice(mesh)})
      EXPECT_EQ(closed_bodies(bad).size(), 1U) << mesh.name;
  EXPECT_EQ(closed_bodies(together(together(box(1), moved(box(1), 3)), post(9))).size(), 2U);
}

TEST(InsideObstacle, a_ribbon_inside_a_body_is_refused_however_its_mesh_is_made) {
  for (const TriangleMesh& mesh : {closed(post(2)), box(2)})
    for (const TriangleMesh& bad : {mesh, with_repeated_corners(mesh), with_some_inside_out(mesh),
                                    with_a_triangle_twice(mesh)})
      EXPECT_THAT(refusal(bad), HasSubstr("lies inside the obstacle")) << mesh.name;
}

TEST(InsideObstacle, a_ribbon_inside_one_of_several_bodies_is_refused) {
  const TriangleMesh beside = moved(box(0.5), 5);
  EXPECT_THAT(refusal(together(beside, box(2))), HasSubstr("lies inside"));
  EXPECT_THAT(refusal(together(moved(post(0.5), 5), box(2))), HasSubstr("lies inside"));
  EXPECT_THAT(refusal(together(box(3), box(2))), HasSubstr("lies inside"));
  EXPECT_EQ(refusal(together(beside, closed(post(0.3)))), "");
}

TEST(InsideObstacle, the_refusal_names_where_the_scene_names_the_mesh) {
  Scene scene = scene_of_loop();
  const RibbonMesh ribbon = mesh_of_loop(scene);
  scene.obstacle = ObstacleScene{{"box.obj", "knot.toml:9:8"}};
  EXPECT_THAT(refusal_of(check_outside(scene, ribbon, box(2))),
              StartsWith("knot.toml:9:8: the ribbon lies inside the obstacle; is curve.unit"));
}

TEST(InsideObstacle, a_ribbon_drawn_inside_is_refused_with_the_question_for_the_unit) {
  // The loop has a radius of 0.5 m and rises by 0.16 m.
  for (const ContactMethod contact : {ContactMethod::gate, ContactMethod::paper})
    EXPECT_THAT(refusal(closed(post(2)), contact),
                StartsWith("loop: the ribbon lies inside the obstacle; is curve.unit right?"));
}

TEST(InsideObstacle, a_ribbon_inside_an_open_mesh_is_accepted) {
  EXPECT_EQ(refusal(post(2)), "");
  EXPECT_EQ(refusal(without_a_triangle(box(2))), "");
}

TEST(InsideObstacle, a_ribbon_round_the_obstacle_is_accepted) {
  EXPECT_EQ(refusal(closed(post(0.3))), "");
}

TEST(InsideObstacle, a_ribbon_in_the_hole_of_a_ring_is_accepted) {
  EXPECT_EQ(refusal(torus(0.8, 1, 0.6)), "");
}

TEST(InsideObstacle, a_ribbon_that_leads_in_and_out_is_told_what_it_pierces_not_that_it_is_inside) {
  TriangleMesh in_the_way = closed(post(0.3));
  in_the_way.vertices.row(2).array() -= 0.5F;
  EXPECT_THAT(refusal(in_the_way), Not(HasSubstr("lies inside")));
}

}  // namespace ribbon::inside_obstacle_test
