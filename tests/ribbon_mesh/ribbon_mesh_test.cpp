#include "ribbon_mesh/ribbon_mesh.h"

#include <gtest/gtest.h>

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

}  // namespace ribbon::ribbon_mesh_test
