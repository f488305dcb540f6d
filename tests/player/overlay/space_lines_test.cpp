#include "player/overlay/space_lines.h"

#include <gtest/gtest.h>

#include "geometry/solids.h"
#include "parallel/any_threads.h"
#include "player/overlay/mesh_lines.h"
#include "player/quads.h"

namespace ribbon::space_lines_test {

constexpr PictureSize size{100, 50};

// Sees 4 m x 2 m of the plane z = 0 from above; a pixel is 4 cm wide there.
Camera above() {
  return {.eye = {0, 0, 10}, .half_width = 0.2F, .half_height = 0.1F};
}

// The ribbon of one quad, x from -2 to 2 and y from -0.5 to 0.5, at height z.
RenderScene scene(float z = 0, const std::optional<TriangleMesh>& obstacle = std::nullopt) {
  RecordingHeader header = test::quad_ribbon();
  header.obstacle = obstacle;
  RenderScene result(header);
  Eigen::Matrix3Xf positions = test::flat_quad();
  positions.row(2).setConstant(z);
  result.set_ribbon(positions);
  return result;
}

Picture drawn(const SpaceLines& lines, const RenderScene& scene, const Camera& camera = above()) {
  Picture picture = blank_picture(size, Color(1, 1, 1));
  draw_lines(lines, {Color(0, 0, 0), 1, 1}, scene, camera, picture);
  return picture;
}

bool is_inked(const Picture& picture, int x, int y) {
  return *picture.pixel(x, y) < 150;
}

int inked(const Picture& picture) {
  int count = 0;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) count += is_inked(picture, x, y) ? 1 : 0;
  return count;
}

SpaceLines line(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  SpaceLines result = polyline(Eigen::Matrix3Xf::Zero(3, 2));
  result.points.col(0) = a;
  result.points.col(1) = b;
  return result;
}

// Along x through row 25 of the picture, one pixel below its middle.
SpaceLines across_picture(float z) {
  const float y = -0.02F * (10 - z) / 10;
  return line({-1.8F, y, z}, {1.8F, y, z});
}

TEST(SpaceLines, a_line_in_a_surface_is_seen_all_along) {
  const Picture picture = drawn(across_picture(0), scene());
  for (int x = 6; x < 94; ++x) EXPECT_TRUE(is_inked(picture, x, 25)) << x;
}

TEST(SpaceLines, behind_the_ribbon_a_line_is_hidden_and_before_it_it_is_not) {
  EXPECT_EQ(inked(drawn(across_picture(-0.01F), scene())), 0);
  EXPECT_GT(inked(drawn(across_picture(0.01F), scene())), 85);
}

TEST(SpaceLines, what_is_hidden_can_be_dimmed_instead) {
  Picture picture = blank_picture(size, Color(1, 1, 1));
  draw_lines(across_picture(-0.01F), {Color(0, 0, 0), 1, 1, 0.5F}, scene(), above(), picture);
  for (int x = 6; x < 94; ++x) EXPECT_NEAR(*picture.pixel(x, 25), 128, 2) << x;
  EXPECT_EQ(inked(drawn(across_picture(-0.01F), scene())), 0);
}

TEST(SpaceLines, an_obstacle_hides_only_what_is_behind_it) {
  const RenderScene with_plate =
      scene(-1, quad_mesh({-0.5F, -0.5F, 1}, {0.5F, -0.5F, 1}, {0.5F, 0.5F, 1}, {-0.5F, 0.5F, 1}));
  const Picture picture = drawn(across_picture(0), with_plate);
  for (int x = 6; x < 94; ++x) {
    // The plate's sides are seen at 0.5 x 10 / 9 m.
    const bool hidden = x > 37 && x < 62;
    const bool beside = x < 35 || x > 65;
    if (hidden || beside) {
      EXPECT_EQ(is_inked(picture, x, 25), beside) << x;
    }
  }
}

TEST(SpaceLines, what_is_beside_or_behind_the_eye_is_left_out) {
  EXPECT_EQ(inked(drawn(line({0, 0, 11}, {1, 0, 20}), scene())), 0);
  EXPECT_EQ(inked(drawn(line({-50, 40, 0}, {50, 40, 0}), scene())), 0);
  // From far beside on the left to behind the eye: what is in the picture is drawn.
  EXPECT_GT(inked(drawn(line({-1e5F, 0.2F, 0}, {1e5F, 0.2F, 0}), scene())), 90);
  EXPECT_GT(inked(drawn(line({-1, 0, 0.1F}, {1, 0, 50}), scene())), 10);
}

TEST(SpaceLines, the_same_for_any_number_of_threads) {
  const RenderScene cloth = scene();
  // Some 420 pieces: more than one thread takes at a time.
  const RibbonGrid grid{12, 6};
  Eigen::Matrix3Xf places(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p)
    places.col(p) << -1.9F + 3.8F * static_cast<float>(grid.row(p)) / 11,
        -0.45F + 0.9F * static_cast<float>(grid.column(p)) / 5, 0.01F;
  const SpaceLines lines = ribbon_lines(grid, places);
  same_for_any_threads([&] { return drawn(lines, cloth).rgb; });
}

TEST(SpaceLines, a_polyline_goes_through_its_points_in_their_order) {
  EXPECT_EQ(polyline(Eigen::Matrix3Xf::Zero(3, 4)).lines.size(), 3U);
  EXPECT_TRUE(polyline(Eigen::Matrix3Xf()).lines.empty());
}

TEST(MeshLines, a_ribbon_has_its_edges_along_and_across) {
  const RibbonGrid grid{5, 3};
  const SpaceLines lines = ribbon_lines(grid, Eigen::Matrix3Xf::Zero(3, 15));
  EXPECT_EQ(lines.lines.size(), 4U * 3 + 5 * 2);
}

TEST(MeshLines, an_edge_between_triangles_is_there_once_even_if_they_share_no_vertices) {
  TriangleMesh mesh = quad_mesh({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  EXPECT_EQ(mesh_lines(mesh).lines.size(), 5U);
  TriangleMesh apart{"", Eigen::Matrix3Xf(3, 6), Eigen::Matrix3Xi(3, 2)};
  for (int k = 0; k < 6; ++k) {
    apart.vertices.col(k) = mesh.vertices.col(mesh.triangles(k % 3, k / 3));
    apart.triangles(k % 3, k / 3) = k;
  }
  EXPECT_EQ(mesh_lines(apart).lines.size(), 5U);
}

}  // namespace ribbon::space_lines_test
