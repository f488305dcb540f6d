#include "ribbon_mesh/ribbon_mesh.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "result/refusal.h"

namespace ribbon::ribbon_mesh_test {

SpaceCurve straight_curve(int samples) {
  SpaceCurve curve;
  curve.points.resize(3, samples);
  for (int i = 0; i < samples; ++i) curve.points.col(i) << 0.5 * i, 0, 0;
  curve.length_m = 0.5 * (samples - 1);
  return curve;
}

TEST(RibbonMesh, of_a_straight_curve_is_a_flat_band_about_it) {
  const RibbonScene ribbon{.width_m = 0.2, .along = 5, .across = 3, .mass_kg = 1};
  const RibbonMesh mesh = generate_ribbon_mesh(straight_curve(5), ribbon, Axis::y);
  ASSERT_EQ(mesh.positions.cols(), 15);
  const auto at = [&](int i, int j) { return mesh.positions.col(mesh.grid.particle(i, j)).eval(); };
  EXPECT_TRUE(at(2, 0).isApprox(Eigen::Vector3d(1, -0.1, 0)));
  EXPECT_TRUE(at(2, 1).isApprox(Eigen::Vector3d(1, 0, 0)));
  EXPECT_TRUE(at(4, 2).isApprox(Eigen::Vector3d(2, 0.1, 0)));
  EXPECT_EQ(mesh.length_m, 2);
  EXPECT_EQ(mesh.curve, straight_curve(5).points);
}

TEST(RibbonMesh, texture_coordinates_run_along_and_across_from_0_to_1) {
  const RibbonScene ribbon{.width_m = 0.2, .along = 5, .across = 3, .mass_kg = 1};
  const RibbonMesh mesh = generate_ribbon_mesh(straight_curve(5), ribbon, Axis::y);
  EXPECT_EQ(mesh.uv.col(mesh.grid.particle(0, 0)), Eigen::Vector2f(0, 0));
  EXPECT_EQ(mesh.uv.col(mesh.grid.particle(1, 1)), Eigen::Vector2f(0.25F, 0.5F));
  EXPECT_EQ(mesh.uv.col(mesh.grid.particle(4, 2)), Eigen::Vector2f(1, 1));
}

TEST(RibbonMesh, of_a_profile_is_as_wide_as_its_rows) {
  const RibbonScene ribbon{.width_m = 0.3,
                           .profile = WidthProfile{{{0, 0.2}, {1, 0.4}}},
                           .along = 5,
                           .across = 3,
                           .mass_kg = 1};
  const RibbonMesh mesh = generate_ribbon_mesh(straight_curve(5), ribbon, Axis::y);
  const RestSize size = mesh.size();
  for (int particle = 0; particle < mesh.grid.particle_count(); ++particle) {
    const Eigen::Vector3d place(mesh.positions.col(particle));
    EXPECT_NEAR(place.x(), size.place_m(particle).x(), 1e-12);
    EXPECT_NEAR(place.y(), size.place_m(particle).y(), 1e-12);
  }
  EXPECT_FLOAT_EQ(static_cast<float>(size.row_width_m(1)), 0.25F);
  EXPECT_EQ(mesh.uv(1, mesh.grid.particle(4, 2)), 1) << "texture coordinates stay";
}

// A straight drawing 1 m long, 101 rows.
std::string refusal_of_profile(std::vector<WidthAt> points, int across) {
  Scene scene;
  scene.curve.drawing = DrawnPoints{{{0, 0}, {500, 0}, {1000, 0}}};
  scene.ribbon = {.width_m = 0.05,
                  .profile = WidthProfile{std::move(points), "knot.toml:7:9"},
                  .along = 101,
                  .across = across};
  scene.curve.clearance_m = 0.005;
  const auto mesh = draw_ribbon(scene);
  return mesh ? "" : refusal_of(mesh);
}

// By hand: an eighth of 10 mm, eight times.
TEST(RibbonMesh, refuses_a_tip_whose_particles_would_set_every_gap) {
  EXPECT_EQ(refusal_of_profile({{0, 0.01001}, {1, 0.1}}, 9), "");
  EXPECT_EQ(refusal_of_profile({{0, 0.008}, {1, 0.1}}, 9),
            "knot.toml:7:9: where the ribbon is 0.008 m wide its particles are 0.001 m apart, less "
            "than an eighth of the 0.01 m from row to row, and would set every gap; set "
            "ribbon.across to 7 or less, or make it no narrower than 0.0101 m");
  EXPECT_EQ(refusal_of_profile({{0, 0.008}, {1, 0.1}}, 7), "") << "as advised";
  EXPECT_EQ(refusal_of_profile({{0, 0.0101}, {1, 0.1}}, 9), "") << "as advised";
}

TEST(RibbonMesh, refuses_a_width_that_changes_faster_than_the_length) {
  const auto refusal = [](double last_m) {
    return refusal_of_profile({{0, 0.1}, {0.5, 0.1}, {0.6, last_m}, {1, last_m}}, 5);
  };
  EXPECT_EQ(refusal(0.16), "");
  EXPECT_EQ(refusal(0.18),
            "knot.toml:7:9: at 0.535 of its length the ribbon becomes wider or narrower by 0.0109 "
            "m from one row to the next, which is 0.01 m away; let its width change over a longer "
            "part of it, by at most as much as the part is long");
}

}  // namespace ribbon::ribbon_mesh_test
