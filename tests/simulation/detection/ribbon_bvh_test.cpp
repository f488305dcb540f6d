#include "simulation/detection/ribbon_bvh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "parallel/any_threads.h"
#include "simulation/detection/closest_weights.h"
#include "simulation/detection/collision_surface.h"
#include "simulation/detection/feature_pairs.h"
#include "simulation/detection/vertex_ranges.h"
#include "simulation/published/planted_penetrations.h"

namespace ribbon::ribbon_bvh_test {

using Eigen::Matrix3Xd;
using Kind = FeaturePair::Kind;

constexpr double reach_m = 0.2;  // edges are 1 m long

// Rolled up to a cylinder of the given radius.
Matrix3Xd rolled(const RibbonGrid& grid, double radius) {
  Matrix3Xd x(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p)
    x.col(p) << radius * std::sin(grid.row(p) / radius), radius * std::cos(grid.row(p) / radius),
        grid.column(p);
  return x;
}

Matrix3Xd turned(const Matrix3Xd& x) {
  return Eigen::Quaterniond(0.5, 0.3, -0.7, 0.4).normalized().toRotationMatrix() * x;
}

std::vector<FeaturePair> pairs_within(RibbonBvh& tree) {
  std::vector<FeaturePair> found;
  tree.list_within(found);
  return found;
}

std::vector<FeaturePair> pairs(const RibbonGrid& grid, const Matrix3Xd& t0, const Matrix3Xd& t1) {
  RibbonBvh tree(grid);
  tree.refit(vertex_ranges(t0, t1), reach_m);
  return pairs_within(tree);
}

TEST(RibbonBvh, a_flat_ribbon_has_no_pairs_to_test_however_it_lies_and_flies) {
  const RibbonGrid grid{60, 6};
  const Matrix3Xd flat = turned(flat_ribbon(grid));
  EXPECT_TRUE(pairs(grid, flat, flat).empty());
  EXPECT_TRUE(pairs(grid, flat, flat.colwise() + Eigen::Vector3d(7, -5, 9)).empty());
}

TEST(RibbonBvh, a_gentle_bend_has_none_but_the_two_ends_of_a_ring_have_some) {
  const RibbonGrid grid{60, 6};
  const double closed = 60 / (2 * std::numbers::pi);
  EXPECT_TRUE(
      pairs(grid, turned(rolled(grid, 2 * closed)), turned(rolled(grid, 2 * closed))).empty());
  const auto of_ring = pairs(grid, rolled(grid, 0.97 * closed), rolled(grid, 0.97 * closed));
  EXPECT_FALSE(of_ring.empty());
  EXPECT_LT(of_ring.size(), 1000U);
}

// The band that curvature by normals alone overlooks: one direction, two layers.
TEST(RibbonBvh, sees_a_band_that_lies_flat_over_itself) {
  const RibbonGrid grid{81, 5};
  Matrix3Xd x(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p) {
    const double angle = 4 * std::numbers::pi * grid.row(p) / 80;
    x.col(p) << (8 + grid.column(p)) * std::cos(angle), 0.002 * grid.row(p),
        (8 + grid.column(p)) * std::sin(angle);
  }
  const auto found = pairs(grid, x, x);
  const auto layers = std::count_if(found.begin(), found.end(), [&](const FeaturePair& pair) {
    return std::abs(grid.row(pair.vertices[0]) - grid.row(pair.vertices[3])) > 20;
  });
  EXPECT_GT(layers, 100);
}

// A pair, whichever of two edges comes first.
using Key = std::array<int, 5>;

Key key_of(const FeaturePair& pair) {
  auto v = pair.vertices;
  const bool edges = pair.kind == Kind::edge_edge;
  std::sort(v.begin() + (edges ? 0 : 1), edges ? v.begin() + 2 : v.end());
  if (edges) std::sort(v.begin() + 2, v.end());
  if (edges && v[0] > v[2]) std::swap_ranges(v.begin(), v.begin() + 2, v.begin() + 2);
  return {static_cast<int>(pair.kind), v[0], v[1], v[2], v[3]};
}

std::set<Key> as_set(const std::vector<FeaturePair>& listed) {
  std::set<Key> result;
  for (const FeaturePair& pair : listed)
    EXPECT_TRUE(result.insert(key_of(pair)).second) << "listed twice";
  return result;
}

// Every two features that share no vertex.
std::vector<FeaturePair> all_pairs(const RibbonGrid& grid) {
  const CollisionSurface surface = collision_surface(grid.triangles());
  std::vector<FeaturePair> pairs;
  for (const auto& t : surface.triangles.colwise())
    for (int v = 0; v < grid.particle_count(); ++v)
      if ((t.array() != v).all()) pairs.push_back({Kind::vertex_triangle, {v, t[0], t[1], t[2]}});
  for (const auto& e : surface.edges)
    for (const auto& f : surface.edges)
      if (e < f && e[0] != f[0] && e[0] != f[1] && e[1] != f[0] && e[1] != f[1])
        pairs.push_back({Kind::edge_edge, {e[0], e[1], f[0], f[1]}});
  return pairs;
}

double smallest_distance_m(const FeaturePair& pair, const Matrix3Xd& t0, const Matrix3Xd& t1) {
  double smallest_m = 1e9;
  for (const double time : {0.0, 0.35, 0.7, 1.0}) {
    const Eigen::Matrix<double, 3, 4> at =
        (1 - time) * corners(pair, t0) + time * corners(pair, t1);
    smallest_m = std::min(smallest_m, (at * closest_weights(pair.kind, at)).norm());
  }
  return smallest_m;
}

// From flat over wrinkled to crumpled, still and moving: what comes within reach is listed.
TEST(RibbonBvh, spares_only_what_stays_apart) {
  const RibbonGrid grid{19, 6};
  const std::vector<FeaturePair> all = all_pairs(grid);
  std::mt19937 random(9);
  std::normal_distribution<double> kick(0, 1);
  std::size_t close = 0;
  std::size_t spared = 0;
  for (int trial = 0; trial < 30; ++trial) {
    Matrix3Xd t0 = turned(trial % 2 == 0 ? flat_ribbon(grid) : folded_ribbon(grid, 0.6));
    for (double& value : t0.reshaped()) value += 0.02 * trial * kick(random);
    Matrix3Xd t1 = t0.colwise() + Eigen::Vector3d(3, 2, 1);
    for (double& value : t1.reshaped()) value += 0.02 * (trial % 5) * kick(random);
    const auto listed = as_set(pairs(grid, t0, t1));
    for (const FeaturePair& pair : all) {
      const bool is_listed = listed.contains(key_of(pair));
      if (smallest_distance_m(pair, t0, t1) > reach_m) {
        spared += is_listed ? 0U : 1U;
        continue;
      }
      ++close;
      ASSERT_TRUE(is_listed) << trial << ": " << testing::PrintToString(pair.vertices);
    }
  }
  EXPECT_GT(close, 3000U);
  EXPECT_GT(spared, 100000U);
}

// A range with room makes flatness harder to prove.
TEST(RibbonBvh, room_in_the_ranges_counts) {
  const RibbonGrid grid{30, 5};
  const Matrix3Xd flat = turned(flat_ribbon(grid));
  RibbonBvh tree(grid);
  for (const double room_m : {0.05, 0.5}) {
    std::vector<MovingBox> ranges = vertex_ranges(flat, flat);
    for (MovingBox& range : ranges) range.end.grow(room_m);
    tree.refit(ranges, reach_m);
    EXPECT_EQ(pairs_within(tree).empty(), room_m < 0.1);
  }
}

TEST(RibbonBvh, lists_what_of_an_obstacle_comes_close) {
  const RibbonGrid grid{30, 5};
  OverFloor planted = ribbon_over_floor(grid, -1);
  const ObstacleBody& floor = *planted.bodies.obstacle;
  Matrix3Xd t1 = planted.positions;
  for (const double sink_m : {0.7, 0.9}) {
    t1.row(1).setConstant(-sink_m);
    RibbonBvh tree(grid);
    tree.refit(vertex_ranges(planted.positions, t1), reach_m);
    std::vector<FeaturePair> found;
    tree.list_with(floor.surface, floor.bvh, floor.vertices, found);
    std::set<int> particles;
    for (const FeaturePair& pair : found)
      if (pair.kind == Kind::vertex_triangle) particles.insert(pair.vertices[0]);
    EXPECT_EQ(particles.size(),
              sink_m > 0.8 ? static_cast<std::size_t>(grid.particle_count()) : 0U);
  }
}

// Crumpled by so much, a different way for each seed.
Matrix3Xd crumpled(const Matrix3Xd& x, double size_m, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift_m(-size_m, size_m);
  return x + Matrix3Xd::NullaryExpr(3, x.cols(), [&] { return shift_m(random); });
}

// Few particles that move elsewhere, and all of more rows than a byte can count.
TEST(RibbonBvh, refitted_around_particles_lists_their_pairs_as_if_refitted_as_a_whole) {
  const RibbonGrid grid{700, 4};
  const Matrix3Xd x = crumpled(rolled(grid, 40), 0.3, 1);
  const Matrix3Xd y = crumpled(rolled(grid, 40), 0.3, 2);
  for (const int every : {1, 301}) {
    Matrix3Xd end = x;
    std::vector<int> changed;
    for (int p = 0; p < grid.particle_count(); p += every) {
      changed.push_back(p);
      end.col(p) = y.col(p);
    }
    RibbonBvh around(grid);
    around.refit(vertex_ranges(x, x), reach_m);
    around.refit_around(changed, vertex_ranges(x, end));
    const std::set<int> all_changed(changed.begin(), changed.end());
    const auto has_changed = [&](const FeaturePair& pair) {
      return std::any_of(pair.vertices.begin(), pair.vertices.end(),
                         [&](int vertex) { return all_changed.contains(vertex); });
    };
    RibbonBvh whole(grid);
    whole.refit(vertex_ranges(x, end), reach_m);
    std::vector<FeaturePair> of_whole = pairs_within(whole);
    std::erase_if(of_whole, [&](const FeaturePair& pair) { return !has_changed(pair); });
    const auto vertices_of = [](const std::vector<FeaturePair>& found) {
      std::set<std::array<int, 4>> all;
      for (const FeaturePair& pair : found) all.insert(pair.vertices);
      return all;
    };
    const auto expected = vertices_of(of_whole);
    EXPECT_GT(expected.size(), changed.size());
    EXPECT_EQ(vertices_of(pairs_within(around)), expected);
  }
}

TEST(RibbonBvh, gives_the_same_pairs_in_the_same_order_for_any_number_of_threads) {
  const RibbonGrid grid{200, 9};
  const Matrix3Xd x = rolled(grid, 9);
  const auto listed = same_for_any_threads([&] {
    std::vector<std::array<int, 4>> vertices;
    for (const FeaturePair& pair : pairs(grid, x, x)) vertices.push_back(pair.vertices);
    return vertices;
  });
  EXPECT_GT(listed.size(), 100U);
}

}  // namespace ribbon::ribbon_bvh_test
