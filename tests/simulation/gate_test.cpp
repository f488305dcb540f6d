#include "simulation/gate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "parallel/parallel.h"
#include "simulation/closest_weights.h"
#include "simulation/planted_penetrations.h"
#include "simulation/recovery.h"
#include "simulation/swept_pairs.h"

namespace ribbon {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Corners = Eigen::Matrix<double, 3, 4>;
using Kind = FeaturePair::Kind;

double smallest_gap_m(Bodies& bodies, const Matrix3Xd& x, double query_m) {
  double smallest = query_m;
  for (const FeaturePair& pair : swept_pairs(bodies, Hierarchy::Spare::boxes, x, x, query_m)) {
    const Corners x_pair = corners(pair, x);
    smallest = std::min(smallest, (x_pair * closest_weights(pair.kind, x_pair)).norm());
  }
  return smallest;
}

Corners vertex_over_triangle() {
  Corners x;
  x << 1, 0, 4, 0, 1, 0, 0, 0, 1, 0, 0, 4;
  return x;
}

TEST(SharesOfWay, without_approach_all_may_go) {
  Corners way = Corners::Zero();
  way.row(0).setConstant(100);
  way(1, 0) = 5;
  EXPECT_EQ(shares_of_way(Kind::vertex_triangle, vertex_over_triangle(), way, 0.1),
            Vector4d::Ones().eval());
}

TEST(SharesOfWay, a_vertex_that_falls_through_stops_with_nine_tenths_of_the_room_used) {
  Corners way = Corners::Zero();
  way(1, 0) = -3;
  // By hand: gap 1, minimum 0.1, room 0.9 * 0.9 = 0.81 of a way of 3.
  const Vector4d shares = shares_of_way(Kind::vertex_triangle, vertex_over_triangle(), way, 0.1);
  EXPECT_NEAR(shares[0], 0.27, 1e-12);
  EXPECT_EQ(shares.tail(3), Vector4d::Ones().tail(3));
}

TEST(SharesOfWay, are_divided_in_proportion_to_the_approach_of_each_side) {
  Corners way = Corners::Zero();
  way(1, 0) = -1;
  way.row(1).tail(3).setConstant(2);
  const Vector4d shares = shares_of_way(Kind::vertex_triangle, vertex_over_triangle(), way, 0.1);
  EXPECT_TRUE(shares.isApprox(Vector4d::Constant(0.27)));
}

TEST(SharesOfWay, closer_than_the_minimum_only_parting_passes) {
  Corners way = Corners::Zero();
  way(1, 0) = -0.01;
  way(0, 1) = 1;
  EXPECT_EQ(shares_of_way(Kind::vertex_triangle, vertex_over_triangle(), way, 2)[0], 0);
  EXPECT_EQ(shares_of_way(Kind::vertex_triangle, vertex_over_triangle(), way, 2)[1], 1);
  way(1, 0) = 0.5;
  EXPECT_EQ(shares_of_way(Kind::vertex_triangle, vertex_over_triangle(), way, 2),
            Vector4d::Ones().eval());
}

TEST(SharesOfWay, keep_the_gap_at_every_instant_for_random_motion) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    const Kind kind = trial % 2 == 0 ? Kind::vertex_triangle : Kind::edge_edge;
    Corners x;
    Corners way;
    for (double& value : x.reshaped()) value = coordinate(random);
    for (double& value : way.reshaped()) value = 3 * coordinate(random);
    const double gap = (x * closest_weights(kind, x)).norm();
    if (gap < 0.05) continue;
    const Vector4d shares = shares_of_way(kind, x, way, 0.04);
    for (int instant = 1; instant <= 20; ++instant) {
      const Corners then = x + way * (instant / 20.0 * shares).asDiagonal();
      EXPECT_GE((then * closest_weights(kind, then)).norm(), 0.04);
    }
  }
}

// So close that rounding turns the line between the closest points: no plane can be relied on.
TEST(SharesOfWay, almost_touching_edges_do_not_slip_through_each_other) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    Corners x;
    Corners way;
    for (double& value : x.reshaped()) value = coordinate(random);
    for (double& value : way.reshaped()) value = 1e-6 * coordinate(random);
    // Moves the second edge until the middles of both are 1e-11 apart.
    const Vector3d normal = (x.col(1) - x.col(0)).cross(x.col(3) - x.col(2)).normalized();
    const Vector3d shift = (x.col(0) + x.col(1) - x.col(2) - x.col(3)) / 2 - 1e-11 * normal;
    x.rightCols(2).colwise() += shift;
    const Vector4d shares = shares_of_way(Kind::edge_edge, x, way, 0.04);
    const Corners end = x + way * shares.asDiagonal();
    const auto side = [](const Corners& c) {
      return (c.col(1) - c.col(0)).cross(c.col(3) - c.col(2)).dot(c.col(0) - c.col(2));
    };
    EXPECT_GT(side(x) * side(end), 0) << trial;
  }
}

// Where the particles of a folded ribbon would land: any way, and the halves toward each other.
Matrix3Xd thrown(const RibbonGrid& grid, const Matrix3Xd& x, std::mt19937& random) {
  std::normal_distribution<double> kick(0, 0.4);
  Matrix3Xd wished = x;
  for (double& value : wished.reshaped()) value += kick(random);
  for (int p = 0; p < grid.particle_count(); ++p) wished(1, p) += grid.row(p) < 10 ? 0.4 : -0.4;
  return wished;
}

TEST(Gate, a_ribbon_thrown_at_itself_never_comes_closer_than_the_gap) {
  const RibbonGrid grid{21, 5};
  Matrix3Xd x = folded_ribbon(grid, 0.5);
  Bodies bodies = ribbon_alone(grid, x);
  std::mt19937 random(5);
  int held_back = 0;
  for (int throw_number = 0; throw_number < 60; ++throw_number) {
    held_back += pass_gate(bodies, 0.02, thrown(grid, x, random), x);
    ASSERT_EQ(count_penetrating_edges(bodies, x), 0) << throw_number;
    ASSERT_GE(smallest_gap_m(bodies, x, 0.05), 0.02 - 1e-12) << throw_number;
  }
  EXPECT_GT(held_back, 100);
}

TEST(Gate, without_it_the_first_throw_intersects) {
  const RibbonGrid grid{21, 5};
  const Matrix3Xd x = folded_ribbon(grid, 0.5);
  Bodies bodies = ribbon_alone(grid, x);
  std::mt19937 random(5);
  EXPECT_GT(count_penetrating_edges(bodies, thrown(grid, x, random)), 0);
}

TEST(Gate, lets_a_sheet_slide_along_another_freely) {
  const RibbonGrid grid{9, 5};
  OverFloor planted = ribbon_over_floor(grid, -0.02);
  Matrix3Xd wished = planted.positions;
  wished.leftCols(grid.particle_count()).colwise() += Vector3d(0.3, 0, 0.2);
  Matrix3Xd x = planted.positions;
  EXPECT_EQ(pass_gate(planted.bodies, 0.01, wished, x), 0);
  EXPECT_EQ(x, wished);
}

TEST(Gate, one_jammed_pair_does_not_stop_the_rest) {
  const RibbonGrid grid{9, 5};
  OverFloor planted = ribbon_over_floor(grid, -1);
  Matrix3Xd wished = planted.positions;
  wished.row(1).leftCols(grid.particle_count()).array() += 0.5;
  wished(1, 0) = -5;
  Matrix3Xd x = planted.positions;
  EXPECT_GE(pass_gate(planted.bodies, 0.01, wished, x), 1);
  EXPECT_GT(x(1, 0), -1);
  EXPECT_EQ(x.col(grid.particle(8, 4)), wished.col(grid.particle(8, 4)));
}

TEST(Gate, gives_the_same_bits_for_any_number_of_threads) {
  const RibbonGrid grid{121, 9};
  std::vector<Matrix3Xd> answers;
  for (const int threads : {1, 2, 5}) {
    set_thread_limit(threads);
    Matrix3Xd x = folded_ribbon(grid, 0.5);
    Bodies bodies = ribbon_alone(grid, x);
    Matrix3Xd wished = x;
    for (int p = 0; p < grid.particle_count(); ++p)
      wished.col(p) += 0.4 * Vector3d(std::sin(p), std::cos(3 * p), std::sin(7 * p));
    pass_gate(bodies, 0.02, wished, x);
    answers.push_back(x);
  }
  set_thread_limit(0);
  EXPECT_EQ(answers[0], answers[1]);
  EXPECT_EQ(answers[0], answers[2]);
}

}  // namespace
}  // namespace ribbon
