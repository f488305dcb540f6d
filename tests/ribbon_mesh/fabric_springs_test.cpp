#include "ribbon_mesh/fabric_springs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "ribbon_mesh/springs.h"

namespace ribbon::fabric_springs_test {

using Eigen::Vector3d;
using Shape = std::function<Vector3d(const Eigen::Vector2d& flat)>;

// A metre of 5 cm, of squares of 12.5 and 10 mm, and twice as fine.
std::vector<RestSize> sizes() {
  return {{{81, 5}, 1, 0.05}, {{101, 6}, 1, 0.05}, {{201, 11}, 1, 0.05}};
}

double stretch_n_m(const Fabric& fabric) {
  return std::min(fabric.stretch_n_m, most_stretch_of_mass_m2_s2 * fabric.mass_kg_m2);
}

// What the springs of the fabric hold in a band of that shape.
double energy_j(const Fabric& fabric, const RestSize& size, const Shape& shape) {
  const SpringNetwork network = spring_network(size, springs_of(fabric, size));
  double sum_j = 0;
  for (const SpringKind* kind : network.kinds())
    for (const SpringFamily& family : kind->families)
      for_each_spring(network.grid, family, [&](int a, int b) {
        const double change_m =
            (shape(size.place_m(a)) - shape(size.place_m(b))).norm() - family.rest_m(a);
        sum_j += 0.5 * kind->stiffness * change_m * change_m;
      });
  return sum_j;
}

// What diagonals bear is theirs: it is that of shear.
TEST(FabricSprings, bear_the_same_along_the_band_however_many_particles_there_are) {
  constexpr double strain = 0.01;
  const Shape stretched = [](const auto& at) { return Vector3d((1 + strain) * at.x(), at.y(), 0); };
  for (const Fabric& fabric : fabrics)
    for (const RestSize& size : sizes()) {
      const double expected_j = 0.5 * (stretch_n_m(fabric) + fabric.shear_n_m) * strain * strain *
                                size.length_m * size.width_m;
      EXPECT_NEAR(energy_j(fabric, size, stretched) / expected_j, 1, 0.02)
          << fabric.name << ", " << size.grid.across;
    }
}

TEST(FabricSprings, shear_as_the_fabric_does) {
  constexpr double angle = 1e-4;
  const Shape sheared = [](const auto& at) { return Vector3d(at.x() + angle * at.y(), at.y(), 0); };
  for (const Fabric& fabric : fabrics)
    for (const RestSize& size : sizes()) {
      const double expected_j =
          0.5 * fabric.shear_n_m * angle * angle * size.length_m * size.width_m;
      EXPECT_NEAR(energy_j(fabric, size, sheared) / expected_j, 1, 1e-3)
          << fabric.name << ", " << size.grid.across;
    }
}

// Rolled up, edge by edge, to a curvature of 1 / cm.
Shape rolled(const RestSize& size) {
  const double a = size.along_m();
  const double turn = a * bending_matched_per_m;
  return [a, turn](const Eigen::Vector2d& at) {
    const double radius = a / (2 * std::sin(turn / 2));
    const double angle = at.x() / a * turn;
    return Vector3d(radius * std::cos(angle), at.y(), radius * std::sin(angle));
  };
}

TEST(FabricSprings, bend_as_the_fabric_does_at_the_curvature_where_it_is_measured) {
  for (const Fabric& fabric : fabrics)
    for (const RestSize& size : {sizes()[0], sizes()[1]}) {
      const double expected_j = 0.5 * fabric.bending_nm * bending_matched_per_m *
                                bending_matched_per_m * size.length_m * size.width_m;
      EXPECT_NEAR(energy_j(fabric, size, rolled(size)) / expected_j, 1, 0.08)
          << fabric.name << ", " << size.grid.across;
    }
}

TEST(FabricSprings, give_way_in_folds_before_they_give_way_in_edges) {
  const RestSize fine{{1601, 81}, 1, 0.05};
  for (const Fabric& fabric : fabrics) {
    const SpringScene springs = springs_of(fabric, fine);
    EXPECT_GE(springs.stretch, 9.99 * springs.bend) << fabric.name;
    EXPECT_GT(springs.bend, 0) << fabric.name;
  }
}

TEST(FabricSprings, weigh_as_much_however_many_particles_there_are) {
  Scene scene;
  scene.cloth = {.fabric = fabrics[0], .tells_mass = true, .tells_shear = true};
  for (const RestSize& size : sizes())
    EXPECT_DOUBLE_EQ(with_fabric(scene, size).ribbon.mass_kg, 0.05 * fabrics[0].mass_kg_m2);
  EXPECT_EQ(with_fabric(scene, sizes()[0]).springs.stretch, 0) << "which the scene says itself";
  EXPECT_TRUE(limited_edges(scene).diagonals);
}

TEST(FabricSprings, are_nothing_to_a_scene_without_a_fabric) {
  Scene scene;
  scene.springs = {.stretch = 1, .shear = 2, .bend = 3, .damping = 4};
  EXPECT_EQ(with_fabric(scene, sizes()[0]), scene);
  EXPECT_EQ(fabric_settings(scene, sizes()[0]), "");
}

TEST(FabricSprings, are_told_as_settings) {
  Scene scene;
  scene.cloth = {.fabric = fabrics[0], .tells_bend = true};
  scene.springs.stretch = 7;
  const std::string text = fabric_settings(scene, sizes()[0]);
  EXPECT_NE(text.find("springs.stretch = 7\n"), std::string::npos) << text;
  EXPECT_NE(text.find("springs.bend = 0."), std::string::npos) << text;
}

}  // namespace ribbon::fabric_springs_test
