#include "model/solid_ribbon.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "model/ribbon_faces.h"
#include "verification/cgal_oracle.h"

namespace ribbon::solid_ribbon_test {

constexpr RibbonGrid grid{.along = 40, .across = 4};
const Eigen::Matrix3Xf no_vertices(3, 0);
const Eigen::Matrix3Xi no_triangles(3, 0);

// A hairpin: 1 m straight, half a turn, and back above itself at a distance of `gap`.
Eigen::Matrix3Xf hairpin(double gap) {
  Eigen::Matrix3Xf positions(3, grid.particle_count());
  const double radius = gap / 2;
  const double turn = std::numbers::pi * radius;
  for (int i = 0; i < grid.along; ++i) {
    const double way = i * (2 + turn) / (grid.along - 1);
    const double angle = std::clamp((way - 1) / radius, 0.0, std::numbers::pi);
    const double straight = std::min(way, 1.0) - std::max(way - 1 - turn, 0.0);
    for (int j = 0; j < grid.across; ++j)
      positions.col(grid.particle(i, j)) << static_cast<float>(straight + radius * std::sin(angle)),
          static_cast<float>(radius * (1 - std::cos(angle))), static_cast<float>(0.03 * j);
  }
  return positions;
}

TriangleSoup soup_of_solid(const Eigen::Matrix3Xf& positions) {
  const Eigen::MatrixXi faces = solid_faces(grid, RibbonFaces::triangles);
  return {.points = positions, .triangles = faces, .judged = static_cast<int>(faces.cols())};
}

std::size_t pairs_that_meet(const Eigen::Matrix3Xf& positions) {
  return cgal_intersecting_pairs(soup_of_solid(positions)).size();
}

void expect_closed(const Eigen::MatrixXi& faces) {
  std::map<std::pair<int, int>, int> directed;
  for (const auto& face : faces.colwise())
    for (Eigen::Index k = 0; k < face.size(); ++k)
      ++directed[{face[k], face[(k + 1) % face.size()]}];
  for (const auto& [edge, count] : directed) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(directed.contains({edge.second, edge.first})) << edge.first << ' ' << edge.second;
  }
}

TEST(SolidFaces, every_edge_has_a_face_on_both_sides) {
  expect_closed(solid_faces(grid, RibbonFaces::triangles));
  expect_closed(solid_faces(grid, RibbonFaces::quads));
}

TEST(SolidFaces, quads_are_split_by_fans_into_the_triangles) {
  const Eigen::MatrixXi quads = solid_faces(grid, RibbonFaces::quads);
  std::multiset<std::set<int>> fans;
  for (const auto& q : quads.colwise()) {
    fans.insert({q[0], q[1], q[2]});
    fans.insert({q[0], q[2], q[3]});
  }
  std::multiset<std::set<int>> triangles;
  const Eigen::MatrixXi faces = solid_faces(grid, RibbonFaces::triangles);
  for (const auto& t : faces.colwise()) triangles.insert({t[0], t[1], t[2]});
  EXPECT_EQ(fans, triangles);
}

double volume(const Eigen::Matrix3Xf& positions) {
  double sixfold = 0;
  const Eigen::Matrix3Xd points = positions.cast<double>();
  const Eigen::MatrixXi faces = solid_faces(grid, RibbonFaces::triangles);
  for (const auto& t : faces.colwise())
    sixfold += points.col(t[0]).dot(points.col(t[1]).cross(points.col(t[2])));
  return sixfold / 6;
}

TEST(SolidRibbon, has_the_volume_of_its_thickness_where_there_is_room) {
  const SolidRibbon solid(grid, 0.002, no_vertices, no_triangles);
  const Eigen::Matrix3Xf raised = solid.raise(hairpin(0.3)).value();
  const double area = (2 + std::numbers::pi * 0.15) * 0.09;
  EXPECT_NEAR(volume(raised), 0.002 * area, 0.02 * 0.002 * area);
  EXPECT_DOUBLE_EQ(solid.least_thickness(), 0.002);
  EXPECT_EQ(pairs_that_meet(raised), 0U);
}

TEST(SolidRibbon, takes_half_of_the_way_to_the_next_layer) {
  const SolidRibbon solid(grid, 0.02, no_vertices, no_triangles);
  const Eigen::Matrix3Xf surface = hairpin(0.01);
  const Eigen::Matrix3Xf raised = solid.raise(surface).value();
  EXPECT_EQ(pairs_that_meet(raised), 0U);
  const int middle = grid.particle(grid.along / 4, 2);  // far from the bend
  const float height = (raised.col(middle) - surface.col(middle)).norm();
  EXPECT_NEAR(height, 0.0049, 1e-6);
  EXPECT_LE(solid.least_thickness(), 0.0098);
}

TEST(SolidRibbon, without_looking_at_the_next_layer_it_would_meet_itself) {
  const Eigen::Matrix3Xf wide = hairpin(0.3);
  const Eigen::Matrix3Xf offset =
      SolidRibbon(grid, 0.02, no_vertices, no_triangles).raise(wide).value() - wide.replicate(1, 2);
  EXPECT_GT(pairs_that_meet(hairpin(0.01).replicate(1, 2) + offset), 0U);
}

TEST(SolidRibbon, keeps_off_the_obstacle) {
  Eigen::Matrix3Xf plane(3, 3);
  plane << -5, 5, 0,           //
      -1e-3F, -1e-3F, -1e-3F,  //
      -5, -5, 5;
  const SolidRibbon solid(grid, 0.02, plane, Eigen::Vector3i(0, 1, 2));
  const Eigen::Matrix3Xf raised = solid.raise(hairpin(0.3)).value();
  EXPECT_GT(raised.row(1).minCoeff(), -1e-3F);
  EXPECT_LT(raised.row(1).minCoeff(), -0.4e-3F);
}

TEST(SolidRibbon, a_surface_that_intersects_is_refused) {
  Eigen::Matrix3Xf crossed = hairpin(0.3);
  crossed.col(grid.particle(0, 0)) << 0.5F, 0.5F, 0.05F;
  EXPECT_FALSE(SolidRibbon(grid, 0.002, no_vertices, no_triangles).raise(crossed));
}

// Turned, so that no coordinate is exact.
TEST(SolidRibbon, thinner_than_single_precision_tells_is_refused_with_a_thickness_that_serves) {
  for (const float angle : {0.2F, 0.7F, 1.1F}) {
    const Eigen::Matrix3f turn =
        Eigen::AngleAxisf(angle, Eigen::Vector3f(1, 2, 3).normalized()).toRotationMatrix();
    Eigen::Matrix3Xf far = turn * hairpin(0.3);
    far.array() += 90;
    const SolidRibbon thin(grid, 1e-6, no_vertices, no_triangles);
    ASSERT_FALSE(thin.raise(far));
    const double told = thin.told_thickness().value();
    EXPECT_LT(told, 1e-4);
    const SolidRibbon thick(grid, told, no_vertices, no_triangles);
    EXPECT_TRUE(thick.raise(far)) << angle;
    EXPECT_FALSE(thick.told_thickness());
  }
}

TEST(SolidRibbon, a_surface_that_intersects_is_not_too_thin) {
  Eigen::Matrix3Xf crossed = hairpin(0.3);
  crossed.col(grid.particle(0, 0)) << 0.5F, 0.5F, 0.05F;
  const SolidRibbon solid(grid, 0.002, no_vertices, no_triangles);
  ASSERT_FALSE(solid.raise(crossed));
  EXPECT_FALSE(solid.told_thickness());
}

// From frame 313 of overhand-hourglass-16x400: nothing intersects, but the triangles around the
// particle in the middle look in all directions.
constexpr RibbonGrid patch{.along = 3, .across = 3};

Eigen::Matrix3Xf crumpled_patch() {
  Eigen::Matrix3Xf tenths_of_mm(3, patch.particle_count());
  tenths_of_mm << -132, -112, -105, -24, 0, 11, 81, 107, 124,  //
      -7, 44, 80, 15, 0, 55, 78, 23, 7,                        //
      5, 25, -26, -49, 0, 5, -39, -58, -6;
  return 1e-4F * tenths_of_mm;
}

TriangleSoup soup_of_patch(const Eigen::Matrix3Xf& positions) {
  const Eigen::MatrixXi faces = solid_faces(patch, RibbonFaces::triangles);
  return {.points = positions, .triangles = faces, .judged = static_cast<int>(faces.cols())};
}

TEST(SolidRibbon, is_pinched_where_no_direction_looks_away_from_all_triangles) {
  const SolidRibbon solid(patch, 0.002, no_vertices, no_triangles);
  const auto raised = solid.raise(crumpled_patch());
  ASSERT_TRUE(raised);
  EXPECT_EQ(solid.most_pinched(), 1);
  EXPECT_EQ(raised->col(4), crumpled_patch().col(4));
  EXPECT_EQ(raised->col(4), raised->col(9 + 4));
  EXPECT_GT(solid.least_thickness(), 1e-4);
  for (const int p : {0, 1, 2, 3, 5, 6, 7, 8})
    EXPECT_GE((raised->col(p) - raised->col(9 + p)).norm(), 0.999 * solid.least_thickness());
}

TEST(SolidRibbon, touches_itself_where_it_is_pinched_and_nowhere_else) {
  const auto raised = SolidRibbon(patch, 0.002, no_vertices, no_triangles).raise(crumpled_patch());
  ASSERT_TRUE(raised);
  TriangleSoup soup = soup_of_patch(*raised);
  EXPECT_FALSE(cgal_intersecting_pairs(soup).empty()) << "front and back are different vertices";
  soup.triangles = (soup.triangles.array() == 9 + 4).select(4, soup.triangles);
  EXPECT_TRUE(cgal_intersecting_pairs(soup).empty());
}

}  // namespace ribbon::solid_ribbon_test
