#include "simulation/patch_tree.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "parallel/parallel.h"
#include "simulation/closest_weights.h"
#include "simulation/collision_surface.h"
#include "simulation/feature_pairs.h"
#include "simulation/planted_penetrations.h"
#include "simulation/vertex_ranges.h"

namespace ribbon {
namespace {

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

std::vector<CandidatePair> pairs(const RibbonGrid& grid, const Matrix3Xd& t0, const Matrix3Xd& t1) {
  const std::vector<MovingBox> ranges = vertex_ranges(t0, t1);
  PatchTree tree(grid);
  tree.refit(ranges, reach_m);
  return tree.pairs_within(ranges);
}

TEST(PatchTree, a_flat_ribbon_has_no_pairs_to_test_however_it_lies_and_flies) {
  const RibbonGrid grid{60, 6};
  const Matrix3Xd flat = turned(flat_ribbon(grid));
  EXPECT_TRUE(pairs(grid, flat, flat).empty());
  EXPECT_TRUE(pairs(grid, flat, flat.colwise() + Eigen::Vector3d(7, -5, 9)).empty());
}

TEST(PatchTree, a_gentle_bend_has_none_but_the_two_ends_of_a_ring_have_some) {
  const RibbonGrid grid{60, 6};
  const double closed = 60 / (2 * std::numbers::pi);
  EXPECT_TRUE(
      pairs(grid, turned(rolled(grid, 2 * closed)), turned(rolled(grid, 2 * closed))).empty());
  const auto of_ring = pairs(grid, rolled(grid, 0.97 * closed), rolled(grid, 0.97 * closed));
  EXPECT_FALSE(of_ring.empty());
  EXPECT_LT(of_ring.size(), 1000U);
}

// The band that curvature by normals alone overlooks: one direction, two layers.
TEST(PatchTree, sees_a_band_that_lies_flat_over_itself) {
  const RibbonGrid grid{81, 5};
  Matrix3Xd x(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p) {
    const double angle = 4 * std::numbers::pi * grid.row(p) / 80;
    x.col(p) << (8 + grid.column(p)) * std::cos(angle), 0.002 * grid.row(p),
        (8 + grid.column(p)) * std::sin(angle);
  }
  const auto found = pairs(grid, x, x);
  const auto layers = std::count_if(found.begin(), found.end(), [&](const CandidatePair& pair) {
    return std::abs(pair.a - pair.b) / 8 > 20;
  });
  EXPECT_GT(layers, 100);
}

std::set<std::array<int, 2>> as_set(const std::vector<CandidatePair>& listed) {
  std::set<std::array<int, 2>> result;
  for (const CandidatePair& pair : listed)
    EXPECT_TRUE(result.insert({std::min(pair.a, pair.b), std::max(pair.a, pair.b)}).second)
        << "listed twice";
  return result;
}

double distance_m(Kind kind, const std::array<int, 4>& v, const Matrix3Xd& x) {
  const auto at = corners({kind, v}, x);
  return (at * closest_weights(kind, at)).norm();
}

// The smallest distance between features of two triangles that share no vertex.
double smallest_distance_m(const Eigen::Vector3i& s, const Eigen::Vector3i& t, const Matrix3Xd& x) {
  const auto is_in = [](int v, const Eigen::Vector3i& of) { return (of.array() == v).any(); };
  double smallest = 1e9;
  for (int i = 0; i < 3; ++i) {
    if (!is_in(s[i], t))
      smallest = std::min(smallest, distance_m(Kind::vertex_triangle, {s[i], t[0], t[1], t[2]}, x));
    if (!is_in(t[i], s))
      smallest = std::min(smallest, distance_m(Kind::vertex_triangle, {t[i], s[0], s[1], s[2]}, x));
    for (int j = 0; j < 3; ++j) {
      const std::array<int, 4> edges = {s[i], s[(i + 1) % 3], t[j], t[(j + 1) % 3]};
      if (std::set(edges.begin(), edges.end()).size() == 4)
        smallest = std::min(smallest, distance_m(Kind::edge_edge, edges, x));
    }
  }
  return smallest;
}

// From flat over wrinkled to crumpled, still and moving: what comes within reach is listed.
TEST(PatchTree, spares_only_what_stays_apart) {
  const RibbonGrid grid{19, 6};
  const Eigen::Matrix3Xi triangles = grid.triangles();
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
    for (int a = 0; a < grid.triangle_count(); ++a)
      for (int b = a + 1; b < grid.triangle_count(); ++b) {
        double smallest_m = 1e9;
        for (const double time : {0.0, 0.35, 0.7, 1.0})
          smallest_m = std::min(smallest_m, smallest_distance_m(triangles.col(a), triangles.col(b),
                                                                (1 - time) * t0 + time * t1));
        if (smallest_m > reach_m) {
          spared += listed.contains({a, b}) ? 0U : 1U;
          continue;
        }
        ++close;
        ASSERT_TRUE(listed.contains({a, b})) << trial << ": " << a << ", " << b;
      }
  }
  EXPECT_GT(close, 3000U);
  EXPECT_GT(spared, 100000U);
}

// A range with room makes flatness harder to prove.
TEST(PatchTree, room_in_the_ranges_counts) {
  const RibbonGrid grid{30, 5};
  const Matrix3Xd flat = turned(flat_ribbon(grid));
  PatchTree tree(grid);
  for (const double room_m : {0.05, 0.5}) {
    std::vector<MovingBox> ranges = vertex_ranges(flat, flat);
    for (MovingBox& range : ranges) range.end.grow(room_m);
    tree.refit(ranges, reach_m);
    EXPECT_EQ(tree.pairs_within(ranges).empty(), room_m < 0.1);
  }
}

TEST(PatchTree, lists_what_of_an_obstacle_comes_close) {
  const RibbonGrid grid{30, 5};
  OverFloor planted = ribbon_over_floor(grid, -1);
  Matrix3Xd t1 = planted.positions;
  for (const double sink_m : {0.7, 0.9}) {
    t1.row(1).leftCols(grid.particle_count()).setConstant(-sink_m);
    PatchTree tree(grid);
    tree.refit(vertex_ranges(planted.positions, t1), reach_m);
    const auto found = tree.pairs_with(planted.bodies.obstacle->hierarchy);
    EXPECT_EQ(found.size(), sink_m > 0.8 ? 2U * static_cast<unsigned>(grid.triangle_count()) : 0U);
  }
}

TEST(PatchTree, gives_the_same_pairs_in_the_same_order_for_any_number_of_threads) {
  const RibbonGrid grid{200, 9};
  const Matrix3Xd x = rolled(grid, 9);
  std::vector<std::vector<CandidatePair>> answers;
  for (const int threads : {1, 2, 5}) {
    set_thread_limit(threads);
    answers.push_back(pairs(grid, x, x));
  }
  set_thread_limit(0);
  ASSERT_GT(answers[0].size(), 100U);
  for (std::size_t i = 1; i < answers.size(); ++i) {
    ASSERT_EQ(answers[i].size(), answers[0].size());
    for (std::size_t n = 0; n < answers[0].size(); ++n)
      ASSERT_TRUE(answers[i][n].a == answers[0][n].a && answers[i][n].b == answers[0][n].b);
  }
}

}  // namespace
}  // namespace ribbon
