#include "simulation/start/width_growth.h"

#include <gtest/gtest.h>

#include "simulation/loop_scene.h"
#include "simulation/published/recovery.h"

namespace ribbon::width_growth_test {

using Eigen::Matrix3Xd;

TEST(WidthGrowth, rows_are_scaled_about_their_centres) {
  const RibbonGrid grid{2, 3};
  Matrix3Xd positions(3, 6);
  positions << 0, 0, 0, 5, 5, 5, 1, 2, 3, 0, 0, 0, 0, 0, 0, 3, 6, 9;
  Matrix3Xd expected(3, 6);
  expected << 0, 0, 0, 5, 5, 5, 1.5, 2, 2.5, 0, 0, 0, 0, 0, 0, 4.5, 6, 7.5;
  EXPECT_EQ(rows_scaled(grid, 0.5, positions), expected);
}

TEST(WidthGrowth, an_edge_of_a_narrower_band_is_shorter_across_only) {
  RibbonMesh ribbon;
  ribbon.grid = {11, 5};
  ribbon.length_m = 2;
  ribbon.width_m = 0.4;
  const RestSize size = ribbon.size().narrowed(0.25);
  EXPECT_DOUBLE_EQ(size.along_m(), 0.2);
  EXPECT_DOUBLE_EQ(size.across_m(), 0.025);
  EXPECT_DOUBLE_EQ(size.shortest_edge_m(), 0.025);
}

TEST(WidthGrowth, with_room_the_band_gets_its_whole_width_and_stays_flat) {
  Scene scene = scene_of_loop();
  scene.ribbon = {.width_m = 0.3, .along = 20, .across = 4, .mass_kg = 1};
  const RibbonMesh ribbon = generate_ribbon_mesh(straight_curve(20, 1.9), scene.ribbon, Axis::y);
  Bodies bodies{ribbon.grid, std::nullopt};
  Cloth cloth{rows_scaled(ribbon.grid, 0.25, ribbon.positions), Matrix3Xd::Zero(3, 80), 0.01};
  std::vector<std::string> told;
  const auto tell = [&](const std::string& what) {
    told.push_back(what);
    return true;
  };
  const GrowthReport report = grow_width(scene, ribbon, 0.25, tell, bodies, cloth);
  ASSERT_GT(told.size(), 20U);
  EXPECT_EQ(told.front(), "the ribbon is grown to 25 % of its width");
  EXPECT_EQ(told.back(), "the ribbon is grown to 100 % of its width");
  EXPECT_TRUE(report.complete);
  EXPECT_EQ(report.settled_fraction, 1);
  EXPECT_EQ(count_penetrating_edges(bodies, cloth.positions), 0);
  EXPECT_LT((cloth.positions - ribbon.positions).cwiseAbs().maxCoeff(), 0.15 * 0.3);
  EXPECT_EQ(cloth.velocities.cwiseAbs().maxCoeff(), 0);
}

TEST(WidthGrowth, with_room_a_band_with_a_profile_gets_all_of_its_widths) {
  Scene scene = scene_of_loop();
  scene.ribbon = with_profile({.width_m = 0.3, .along = 20, .across = 4, .mass_kg = 1});
  const RibbonMesh ribbon = generate_ribbon_mesh(straight_curve(20, 1.9), scene.ribbon, Axis::y);
  Bodies bodies{ribbon.grid, std::nullopt};
  Cloth cloth{rows_scaled(ribbon.grid, 0.25, ribbon.positions), Matrix3Xd::Zero(3, 80), 0.01,
              lightness(ribbon.size())};
  EXPECT_TRUE(grow_width(scene, ribbon, 0.25, {}, bodies, cloth).complete);
  EXPECT_LT((cloth.positions - ribbon.positions).cwiseAbs().maxCoeff(), 0.15 * 0.3);
}

TEST(WidthGrowth, a_band_that_nothing_can_settle_is_soon_given_up_and_told_with_the_place) {
  Scene scene = scene_of_loop();
  scene.ribbon.across = 2;
  const RibbonMesh ribbon = mesh_of_loop(scene);
  Bodies bodies{ribbon.grid, std::nullopt};
  Cloth cloth{ribbon.positions, Matrix3Xd::Zero(3, ribbon.positions.cols()), 0.001};
  // Torn apart over row 60 by a hundred times its length.
  cloth.positions.rightCols(ribbon.grid.particle(60, 0)).row(1).array() += 400;
  const GrowthReport report = grow_width(scene, ribbon, 0.5, {}, bodies, cloth);
  EXPECT_FALSE(report.complete);
  EXPECT_EQ(report.settled_fraction, 0);
  EXPECT_NEAR(ribbon.grid.row(report.strained_particle), 60, 12);
  EXPECT_LT(report.steps, 6);
}

}  // namespace ribbon::width_growth_test
