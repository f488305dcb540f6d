#include "simulation/truncation/separating_plane.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "simulation/detection/closest_weights.h"

namespace ribbon::separating_plane_test {

using Eigen::Vector3d;
using Eigen::Vector4d;
using Corners = Eigen::Matrix<double, 3, 4>;
using Kind = FeaturePair::Kind;

Corners vertex_over_triangle() {
  Corners x;
  x << 1, 0, 4, 0, 1, 0, 0, 0, 1, 0, 0, 4;
  return x;
}

Vector4d fractions_of(Kind kind, const Corners& start, const Corners& displacement,
                      double min_separation_m) {
  return displacement_fractions(kind, start, closest_weights(kind, start), displacement,
                                min_separation_m);
}

TEST(DisplacementFractions, without_approach_all_may_go) {
  Corners displacement = Corners::Zero();
  displacement.row(0).setConstant(100);
  displacement(1, 0) = 5;
  EXPECT_EQ(fractions_of(Kind::vertex_triangle, vertex_over_triangle(), displacement, 0.1),
            Vector4d::Ones().eval());
}

TEST(DisplacementFractions, a_vertex_that_falls_through_stops_with_nine_tenths_of_the_room_used) {
  Corners displacement = Corners::Zero();
  displacement(1, 0) = -3;
  // By hand: gap 1, minimum 0.1, room 0.9 * 0.9 = 0.81 of a displacement of 3.
  const Vector4d fractions =
      fractions_of(Kind::vertex_triangle, vertex_over_triangle(), displacement, 0.1);
  EXPECT_NEAR(fractions[0], 0.27, 1e-12);
  EXPECT_EQ(fractions.tail(3), Vector4d::Ones().tail(3));
}

// It comes from beside the triangle, high enough.
TEST(DisplacementFractions, a_vertex_that_slides_over_a_triangle_may_go_all_the_way) {
  Corners x = vertex_over_triangle();
  x.col(0) << -2, 0.2, 3;
  Corners displacement = Corners::Zero();
  displacement.col(0) << 5, 0, -1;
  EXPECT_EQ(fractions_of(Kind::vertex_triangle, x, displacement, 0.1), Vector4d::Ones().eval());
  displacement(1, 0) = -0.15;
  EXPECT_LT(fractions_of(Kind::vertex_triangle, x, displacement, 0.1)[0], 1);
}

TEST(DisplacementFractions, edges_that_slide_over_each_other_may_go_all_the_way) {
  Corners x;
  x << 0, 1, 2, 1.5,   //
      0.2, 0.2, 0, 0,  //
      0, 0.1, 1, -1;
  Corners displacement = Corners::Zero();
  displacement.leftCols(2).colwise() += Vector3d(4, 0, 0);
  EXPECT_EQ(fractions_of(Kind::edge_edge, x, displacement, 0.1), Vector4d::Ones().eval());
}

TEST(DisplacementFractions, are_divided_in_proportion_to_the_approach_of_each_side) {
  Corners displacement = Corners::Zero();
  displacement(1, 0) = -1;
  displacement.row(1).tail(3).setConstant(2);
  const Vector4d fractions =
      fractions_of(Kind::vertex_triangle, vertex_over_triangle(), displacement, 0.1);
  EXPECT_TRUE(fractions.isApprox(Vector4d::Constant(0.27)));
}

TEST(DisplacementFractions, closer_than_the_minimum_only_parting_passes) {
  Corners displacement = Corners::Zero();
  displacement(1, 0) = -0.01;
  displacement(0, 1) = 1;
  EXPECT_EQ(fractions_of(Kind::vertex_triangle, vertex_over_triangle(), displacement, 2)[0], 0);
  EXPECT_EQ(fractions_of(Kind::vertex_triangle, vertex_over_triangle(), displacement, 2)[1], 1);
  displacement(1, 0) = 0.5;
  EXPECT_EQ(fractions_of(Kind::vertex_triangle, vertex_over_triangle(), displacement, 2),
            Vector4d::Ones().eval());
}

TEST(DisplacementFractions, keep_the_gap_at_every_instant_for_random_motion) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  int tried = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Kind kind = trial % 2 == 0 ? Kind::vertex_triangle : Kind::edge_edge;
    Corners x;
    Corners displacement;
    for (double& value : x.reshaped()) value = coordinate(random);
    for (double& value : displacement.reshaped()) value = 3 * coordinate(random);
    const double gap = (x * closest_weights(kind, x)).norm();
    if (gap < 0.05) continue;
    ++tried;
    const Vector4d fractions = fractions_of(kind, x, displacement, 0.04);
    for (int instant = 1; instant <= 20; ++instant) {
      // Another pair may stop any of them earlier.
      Vector4d parts = fractions;
      if (instant % 2 == 0)
        for (double& part : parts) part *= (1 + coordinate(random)) / 2;
      const Corners then = x + displacement * (instant / 20.0 * parts).asDiagonal();
      EXPECT_GE((then * closest_weights(kind, then)).norm(), 0.04);
    }
  }
  EXPECT_GT(tried, 1000);
}

// So close that rounding turns the line between the closest points: no plane can be relied on.
TEST(DisplacementFractions, almost_touching_edges_do_not_slip_through_each_other) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    Corners x;
    Corners displacement;
    for (double& value : x.reshaped()) value = coordinate(random);
    for (double& value : displacement.reshaped()) value = 1e-6 * coordinate(random);
    // Moves the second edge until the middles of both are 1e-11 apart.
    const Vector3d normal = (x.col(1) - x.col(0)).cross(x.col(3) - x.col(2)).normalized();
    const Vector3d shift = (x.col(0) + x.col(1) - x.col(2) - x.col(3)) / 2 - 1e-11 * normal;
    x.rightCols(2).colwise() += shift;
    const Vector4d fractions = fractions_of(Kind::edge_edge, x, displacement, 0.04);
    const Corners end = x + displacement * fractions.asDiagonal();
    const auto side = [](const Corners& c) {
      return (c.col(1) - c.col(0)).cross(c.col(3) - c.col(2)).dot(c.col(0) - c.col(2));
    };
    EXPECT_GT(side(x) * side(end), 0) << trial;
  }
}

}  // namespace ribbon::separating_plane_test
