#include "player/render/surface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "parallel/instruction_set.h"
#include "player/quads.h"

namespace ribbon::surface_test {

// Two squares that meet at the z axis; the second is turned up by `degrees`.
TriangleMesh hinge(float degrees) {
  const float angle = degrees * std::numbers::pi_v<float> / 180;
  TriangleMesh mesh{"hinge", Eigen::Matrix3Xf(3, 6), Eigen::Matrix3Xi(3, 4)};
  mesh.vertices << -1, -1, 0, 0, std::cos(angle), std::cos(angle),  //
      0, 0, 0, 0, std::sin(angle), std::sin(angle),                 //
      0, 1, 1, 0, 1, 0;
  mesh.triangles << 0, 0, 3, 3, 1, 2, 2, 4, 2, 3, 4, 5;
  return mesh;
}

// Mean normal over the corners that lie on the hinge and belong to triangle t.
Eigen::Vector3f normal_at_hinge(const Surface& surface, int t) {
  for (const int vertex : surface.triangles.col(t))
    if (surface.vertices(0, vertex) == 0) return surface.normals.col(vertex);
  return Eigen::Vector3f::Zero();
}

TEST(CreasedSurface, small_angles_are_smooth) {
  const Surface surface = creased_surface(hinge(20));
  const Eigen::Vector3f expected(-std::sin(10 * std::numbers::pi_v<float> / 180),
                                 std::cos(10 * std::numbers::pi_v<float> / 180), 0);
  // One of the two corners on the hinge touches two triangles of one square, so the mean leans.
  EXPECT_GT(normal_at_hinge(surface, 0).dot(expected), 0.995F);
  EXPECT_LT(normal_at_hinge(surface, 0).x(), -0.05F);
}

TEST(CreasedSurface, large_angles_stay_sharp) {
  const Surface surface = creased_surface(hinge(60));
  EXPECT_TRUE(normal_at_hinge(surface, 0).isApprox(Eigen::Vector3f::UnitY(), 1e-6F));
}

TEST(CreasedSurface, repeated_vertices_do_not_make_a_crease) {
  TriangleMesh split = hinge(20);
  split.vertices.conservativeResize(3, 8);
  split.vertices.col(6) = split.vertices.col(2);
  split.vertices.col(7) = split.vertices.col(3);
  split.triangles.col(2) << 7, 6, 4;
  split.triangles.col(3) << 7, 4, 5;
  EXPECT_TRUE(creased_surface(split).normals.isApprox(creased_surface(hinge(20)).normals, 1e-6F));
}

TEST(CreasedSurface, a_triangle_without_area_does_no_harm) {
  TriangleMesh mesh = hinge(20);
  mesh.triangles.col(1) << 1, 1, 1;
  EXPECT_TRUE(creased_surface(mesh).normals.allFinite());
}

TEST(RibbonSurface, normals_point_to_the_front) {
  const Surface ribbon = test::quad_surface(test::flat_quad());
  for (const auto normal : ribbon.normals.colwise())
    EXPECT_TRUE(normal.isApprox(Eigen::Vector3f::UnitZ(), 1e-6F));
}

TEST(RibbonSurface, a_ribbon_crumpled_into_a_point_has_no_normals) {
  EXPECT_TRUE(test::quad_surface(Eigen::Matrix3Xf::Ones(3, 4)).normals.isZero());
}

// A grid as wide as asked for, crumpled at random.
Eigen::Matrix3Xf crumpled(const RibbonGrid& grid) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> shift(-0.4F, 0.4F);
  Eigen::Matrix3Xf positions(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p)
    positions.col(p) << static_cast<float>(grid.row(p)) + shift(random),
        static_cast<float>(grid.column(p)) + shift(random), shift(random);
  return positions;
}

TEST(RibbonSurface, normals_are_those_of_quads_however_wide) {
  for (const int across : {2, 3, 16, 64, 65, 130}) {
    const RibbonGrid grid{5, across};
    const Eigen::Matrix3Xf positions = crumpled(grid);
    Surface ribbon = ribbon_surface(grid);
    update_ribbon(grid, positions, ribbon);
    const auto edge = [&](int from, int to) -> Eigen::Vector3f {
      return positions.col(to) - positions.col(from);
    };
    Eigen::Matrix3Xf normals = Eigen::Matrix3Xf::Zero(3, grid.particle_count());
    for (int q = 0; q < grid.quad_count(); ++q) {
      const auto c = grid.quad(q);
      for (const int corner : c) normals.col(corner) += edge(c[0], c[2]).cross(edge(c[1], c[3]));
    }
    EXPECT_LT((ribbon.normals - normals.colwise().normalized()).cwiseAbs().maxCoeff(), 1e-4F)
        << across;
  }
}

TEST(RibbonSurface, is_the_same_bits_with_all_instruction_sets) {
  const RibbonGrid grid{9, 67};
  const auto surface = [&](InstructionSet set) {
    choose_instruction_set(set);
    Surface ribbon = ribbon_surface(grid);
    update_ribbon(grid, crumpled(grid), ribbon);
    choose_instruction_set(best_instruction_set());
    return ribbon;
  };
  const Surface plain = surface(InstructionSet::baseline);
  const Surface widest = surface(best_instruction_set());
  EXPECT_EQ(plain.normals, widest.normals);
}

TEST(Selvages, stand_upright_along_the_sides_as_high_as_the_cloth_is_thick) {
  const RibbonGrid grid{2, 2};
  Surface ribbon = ribbon_surface(grid);
  add_selvages(grid, ribbon);
  update_ribbon(grid, test::flat_quad(), ribbon);
  update_selvages(grid, {0.1F, 0.2F, 0.1F, 0.2F}, ribbon);
  ASSERT_EQ(ribbon.vertices.cols(), 4 + 8);
  ASSERT_EQ(ribbon.triangles.cols(), 2 + 4);
  for (int vertex = 4; vertex < 12; ++vertex) {
    const int particle = particle_of(grid, vertex);
    const Eigen::Vector3f away = ribbon.vertices.col(vertex) - ribbon.vertices.col(particle);
    const float half = particle % 2 == 0 ? 0.1F : 0.2F;
    EXPECT_LT((away.cwiseAbs() - Eigen::Vector3f(0, 0, half)).norm(), 1e-6F) << vertex;
    const float side = particle % 2 == 0 ? -1 : 1;
    EXPECT_LT((ribbon.normals.col(vertex) - Eigen::Vector3f(0, side, 0)).norm(), 1e-6F);
  }
  for (Eigen::Index t = 2; t < 6; ++t) {
    const Eigen::Vector3i corner = ribbon.triangles.col(t);
    const auto edge = [&](int to) -> Eigen::Vector3f {
      return ribbon.vertices.col(corner[to]) - ribbon.vertices.col(corner[0]);
    };
    const Eigen::Vector3f facet = edge(1).cross(edge(2)).normalized();
    EXPECT_LT((facet - ribbon.normals.col(corner[0])).norm(), 1e-6F) << "outward";
  }
}

}  // namespace ribbon::surface_test
