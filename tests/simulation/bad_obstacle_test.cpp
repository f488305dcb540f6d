// Obstacles as bad as files hold them: the ribbon is drawn tight on each, and no frame intersects.
// The frames are judged by the exact verification, which knows nothing of the gate.
#include <gtest/gtest.h>

#include "simulation/fastening_processor.h"
#include "simulation/frame_judge.h"
#include "simulation/loop_scene.h"

namespace ribbon::bad_obstacle_test {

using Eigen::Vector3f;

int add_vertex(TriangleMesh& mesh, const Vector3f& vertex) {
  mesh.vertices.conservativeResize(3, mesh.vertices.cols() + 1);
  mesh.vertices.rightCols(1) = vertex;
  return static_cast<int>(mesh.vertices.cols()) - 1;
}

void add_triangle(TriangleMesh& mesh, int a, int b, int c) {
  mesh.triangles.conservativeResize(3, mesh.triangles.cols() + 1);
  mesh.triangles.rightCols(1) << a, b, c;
}

// Drawn tight for 60 steps and free in each; and it came to touch the obstacle on its way. Returns
// how near the ribbon's middle came to the axis.
double draw_tight(const TriangleMesh& obstacle) {
  const Scene scene = scene_of_loop();
  const RibbonMesh mesh = mesh_of_loop(scene);
  auto fastening = FasteningProcessor::create(scene, mesh, obstacle);
  if (!fastening) {
    ADD_FAILURE() << fastening.error().sentence();
    return 0;
  }
  const FrameJudge judge(mesh, obstacle);
  double nearest_m = loop_radius_m;
  for (int step = 0; step < 70; ++step) {
    const Eigen::Matrix3Xd positions = fastening->positions();
    EXPECT_TRUE(judge.is_free(positions)) << step;
    if (testing::Test::HasFailure()) return 0;
    const auto middle = positions.col(mesh.grid.particle(mesh.grid.along / 2, 1));
    nearest_m = std::min(nearest_m, std::hypot(middle[0], middle[2]));
    fastening->step();
  }
  return nearest_m;
}

constexpr double radius_m = 0.4;

TEST(BadObstacle, a_sound_one_for_comparison_stops_the_ribbon) {
  EXPECT_GT(draw_tight(post(radius_m)), 0.39);
  EXPECT_LT(draw_tight(post(0.1)), 0.38);
}

TEST(BadObstacle, inverted_normals_stop_it_all_the_same) {
  TriangleMesh mesh = post(radius_m);
  mesh.triangles.row(1).swap(mesh.triangles.row(2));
  EXPECT_GT(draw_tight(mesh), 0.39);
}

TEST(BadObstacle, normals_that_alternate_stop_it_all_the_same) {
  TriangleMesh mesh = post(radius_m);
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); t += 2)
    std::swap(mesh.triangles(1, t), mesh.triangles(2, t));
  EXPECT_GT(draw_tight(mesh), 0.39);
}

TEST(BadObstacle, an_open_half_has_edges_like_razors) {
  TriangleMesh mesh = post(radius_m);
  mesh.triangles = mesh.triangles.leftCols(mesh.triangles.cols() / 2).eval();
  draw_tight(mesh);
}

TEST(BadObstacle, a_blade_without_thickness_is_not_cut_through) {
  EXPECT_GT(
      draw_tight(quad_mesh({0, -0.6F, 0}, {0, -0.6F, -0.42F}, {0, 0.6F, -0.42F}, {0, 0.6F, 0})),
      0.41);
}

TEST(BadObstacle, duplicate_triangles_change_nothing) {
  TriangleMesh mesh = post(radius_m);
  const Eigen::Matrix3Xi once = mesh.triangles;
  mesh.triangles.resize(3, 3 * once.cols());
  mesh.triangles << once, once, once.colwise().reverse();
  EXPECT_GT(draw_tight(mesh), 0.39);
}

TEST(BadObstacle, a_fin_that_shares_an_edge_with_two_others_is_met) {
  TriangleMesh mesh = post(radius_m);
  // Over the edge between low and high at the far side: sides / 2 is where z is smallest.
  const int low = 2 * 12;
  const int tip = add_vertex(mesh, {0, 0, -0.44F});
  add_triangle(mesh, low, low + 1, tip);
  add_triangle(mesh, low + 1, low, tip);
  EXPECT_GT(draw_tight(mesh), 0.43);
}

TEST(BadObstacle, triangles_without_area_stop_it_as_segments) {
  // A fence of upright segments, each a triangle that uses one corner twice or has its third corner
  // on the line of the others.
  TriangleMesh mesh = post(radius_m, 60);
  for (int s = 0; s < 60; ++s) {
    const Eigen::Index t = 2 * Eigen::Index{s};
    mesh.triangles.col(t) << 2 * s, 2 * s + 1, 2 * s + 1;
    mesh.triangles.col(t + 1) << 2 * s + 1, 2 * s, 2 * s;
  }
  EXPECT_GT(draw_tight(mesh), 0.38);
  const Eigen::Index t = 24;
  const int middle = add_vertex(mesh, 0.5F * (mesh.vertices.col(t) + mesh.vertices.col(t + 1)));
  mesh.triangles.col(t) << static_cast<int>(t), static_cast<int>(t) + 1, middle;
  EXPECT_GT(draw_tight(mesh), 0.38);
}

TEST(BadObstacle, triangles_that_are_points_stop_it_as_points) {
  TriangleMesh mesh;
  mesh.name = "points";
  // So dense that no quad of the ribbon, 34 mm x 20 mm, passes between them.
  constexpr int sides = 120;
  constexpr int levels = 41;
  for (int level = 0; level < levels; ++level)
    for (int s = 0; s < sides; ++s) {
      const double angle = 2 * std::numbers::pi * s / sides;
      const Vector3f place(static_cast<float>(radius_m * std::sin(angle)),
                           static_cast<float>(0.01 * level - 0.2),
                           static_cast<float>(radius_m * std::cos(angle)));
      const int vertex = add_vertex(mesh, place);
      add_triangle(mesh, vertex, vertex, vertex);
    }
  EXPECT_GT(draw_tight(mesh), 0.38);
}

TEST(BadObstacle, coincident_vertices_that_are_not_joined_leave_no_crack) {
  const TriangleMesh sound = post(radius_m);
  TriangleMesh mesh;
  mesh.name = "soup";
  for (Eigen::Index t = 0; t < sound.triangles.cols(); ++t) {
    std::array<int, 3> corners{};
    for (int c = 0; c < 3; ++c)
      corners[static_cast<std::size_t>(c)] =
          add_vertex(mesh, sound.vertices.col(sound.triangles(c, t)));
    add_triangle(mesh, corners[0], corners[1], corners[2]);
  }
  EXPECT_GT(draw_tight(mesh), 0.39);
}

TEST(BadObstacle, a_hole_smaller_than_an_edge_is_no_trap) {
  TriangleMesh mesh = post(radius_m);
  // One quad of the tube gives way to a frame with a hole of 5 mm in it.
  const int low = 2 * 12;
  const Vector3f centre = 0.25F * (mesh.vertices.col(low) + mesh.vertices.col(low + 1) +
                                   mesh.vertices.col(low + 2) + mesh.vertices.col(low + 3));
  const std::array<int, 4> outer = {low, low + 2, low + 3, low + 1};
  std::array<int, 4> inner{};
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector3f towards = (mesh.vertices.col(outer[k]) - centre).normalized();
    inner[k] = add_vertex(mesh, centre + 0.0025F * towards);
  }
  mesh.triangles.col(low) << outer[0], outer[1], inner[1];
  mesh.triangles.col(low + 1) << outer[0], inner[1], inner[0];
  for (std::size_t k = 1; k < 4; ++k) {
    add_triangle(mesh, outer[k], outer[(k + 1) % 4], inner[(k + 1) % 4]);
    add_triangle(mesh, outer[k], inner[(k + 1) % 4], inner[k]);
  }
  EXPECT_GT(draw_tight(mesh), 0.39);
}

TEST(BadObstacle, vertices_without_triangles_are_not_there) {
  TriangleMesh mesh = post(0.1);
  for (int s = 0; s < 50; ++s) add_vertex(mesh, {0.4F, 0.002F * static_cast<float>(s), 0});
  EXPECT_LT(draw_tight(mesh), 0.38);
}

TEST(BadObstacle, far_more_triangles_than_the_ribbon_has_all_slivers_stop_it) {
  // 0.6 mm x 1.2 m each.
  EXPECT_GT(draw_tight(post(radius_m, 4000)), 0.39);
}

TEST(BadObstacle, one_that_intersects_itself_stops_it) {
  EXPECT_GT(draw_tight(together(post(radius_m), post(0.39, 7))), 0.39);
}

}  // namespace ribbon::bad_obstacle_test
