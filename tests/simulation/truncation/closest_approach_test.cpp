#include "simulation/truncation/closest_approach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "simulation/detection/closest_weights.h"

namespace ribbon::closest_approach_test {

using Eigen::Vector3d;
using Eigen::Vector4d;
using Corners = Eigen::Matrix<double, 3, 4>;
using Kind = FeaturePair::Kind;

// A pair of features, the first of which is to move past the second.
struct Passing {
  Kind kind = Kind::vertex_triangle;
  Corners start;
  Corners displacement = Corners::Zero();

  [[nodiscard]] ClosestApproach approach() const {
    return closest_approach(kind, start, closest_weights(kind, start), displacement);
  }
  [[nodiscard]] Vector3d closest() const { return approach().apart; }
  [[nodiscard]] double distance_after(double part) const {
    const Corners then = start + part * displacement;
    return (then * closest_weights(kind, then)).norm();
  }
};

Passing random_passing(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Passing pair;
  pair.kind = random() % 2 == 0 ? Kind::vertex_triangle : Kind::edge_edge;
  for (double& value : pair.start.reshaped()) value = coordinate(random);
  const Vector3d way = 3 * Vector3d(coordinate(random), coordinate(random), coordinate(random));
  pair.displacement.leftCols(first_count(pair.kind)).colwise() += way;
  return pair;
}

TEST(ClosestApproach, is_the_least_distance_on_the_way) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 500; ++trial) {
    const Passing pair = random_passing(random);
    constexpr int instants = 1000;
    double least = std::numeric_limits<double>::infinity();
    for (int instant = 0; instant <= instants; ++instant)
      least = std::min(least, pair.distance_after(1.0 * instant / instants));
    const double found = pair.closest().norm();
    // Between two instants the distance changes by no more than half of the way between them.
    const double between = pair.displacement.col(0).norm() / (2 * instants);
    EXPECT_LE(found, least + 1e-12) << trial;
    EXPECT_GE(found, least - between) << trial;
    if (found == 0) continue;
    EXPECT_NEAR(pair.distance_after(pair.approach().when), found, 1e-9) << trial;
  }
}

TEST(ClosestApproach, leaves_a_plane_that_neither_touches_on_the_way) {
  std::mt19937 random(6);
  int apart = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Passing pair = random_passing(random);
    const Vector3d closest = pair.closest();
    const double distance = closest.norm();
    if (distance < 0.01) continue;
    ++apart;
    const Vector3d normal = closest / distance;
    const Vector4d before = pair.start.transpose() * normal;
    const Vector4d after = (pair.start + pair.displacement).transpose() * normal;
    const int first = first_count(pair.kind);
    EXPECT_GE(std::min(before.head(first).minCoeff(), after.head(first).minCoeff()),
              before.tail(4 - first).maxCoeff() + distance - 1e-9)
        << trial;
  }
  EXPECT_GT(apart, 1000);
}

// By hand: it comes over the triangle's slanting edge, and is as high above it all the time.
TEST(ClosestApproach, of_a_vertex_that_slides_over_a_triangle_is_upright) {
  Passing pair;
  pair.start << -1, 0, 4, 1,  //
      0.1, 0, 0, 0,           //
      1, 0, 0, 4;
  pair.displacement.col(0) << 2.5, 0, 0;
  EXPECT_TRUE(pair.closest().isApprox(Vector3d(0, 0.1, 0)));
}

// What both go together makes no difference.
TEST(ClosestApproach, heeds_only_what_the_features_move_differently) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 100; ++trial) {
    Passing pair = random_passing(random);
    const Vector3d closest = pair.closest();
    pair.displacement.colwise() += Vector3d(3, -1, 2);
    EXPECT_TRUE(pair.closest().isApprox(closest, 1e-6)) << trial;
  }
}

}  // namespace ribbon::closest_approach_test
