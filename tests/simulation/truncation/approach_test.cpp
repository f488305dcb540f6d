#include "simulation/truncation/approach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "simulation/detection/closest_weights.h"

namespace ribbon::approach_test {

using Eigen::Vector3d;
using Eigen::Vector4d;
using Corners = Eigen::Matrix<double, 3, 4>;
using Kind = FeaturePair::Kind;

constexpr double near_m = 0.02;

// A pair of features, the first of which is to move past the second.
struct Passing {
  Kind kind = Kind::vertex_triangle;
  Corners start;
  Corners displacement = Corners::Zero();

  [[nodiscard]] Approach approach() const {
    return approach_down_to(near_m, kind, start, closest_weights(kind, start), displacement);
  }
  [[nodiscard]] Vector3d apart() const { return approach().apart; }
  [[nodiscard]] double way_m() const { return displacement.col(0).norm(); }
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

// Its distances at instants from the start to this part of the way.
std::vector<double> distances_until(const Passing& pair, double part) {
  constexpr int instants = 1000;
  std::vector<double> distances;
  for (int instant = 0; instant <= instants; ++instant)
    distances.push_back(pair.distance_after(part * instant / instants));
  return distances;
}

double least(const std::vector<double>& values) {
  return *std::min_element(values.begin(), values.end());
}

TEST(Approach, is_the_least_distance_on_the_way_or_the_first_that_is_small) {
  std::mt19937 random(5);
  int passing = 0;
  int meeting = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const Passing pair = random_passing(random);
    if (pair.distance_after(0) <= near_m) continue;
    const double least_on_way = least(distances_until(pair, 1));
    // Between two instants the distance changes by no more than half of the way between them.
    const double between = pair.way_m() / 2000;
    const Approach found = pair.approach();
    const double distance = found.apart.norm();
    EXPECT_NEAR((found.corners * closest_weights(pair.kind, found.corners)).norm(), distance, 1e-9);
    if (least_on_way - between > near_m) {
      ++passing;
      EXPECT_LE(distance, least_on_way + 1e-12) << trial;
      EXPECT_GE(distance, least_on_way - between) << trial;
    } else if (least_on_way < near_m) {
      ++meeting;
      EXPECT_GE(distance, near_m * (1 - 1e-9)) << trial;
      EXPECT_LE(distance, near_m * 1.01) << trial;
      const double when = (found.corners - pair.start).col(0).norm() / pair.way_m();
      EXPECT_GE(least(distances_until(pair, when)), distance - 1e-9) << trial;
    }
  }
  EXPECT_GT(passing, 100);
  EXPECT_GT(meeting, 40);
}

TEST(Approach, leaves_a_plane_that_neither_touches_on_the_way_there) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 2000; ++trial) {
    const Passing pair = random_passing(random);
    if (pair.distance_after(0) <= near_m) continue;
    const Approach found = pair.approach();
    const double distance = found.apart.norm();
    const Vector3d normal = found.apart / distance;
    const Vector4d before = pair.start.transpose() * normal;
    const Vector4d then = found.corners.transpose() * normal;
    const int first = first_count(pair.kind);
    EXPECT_GE(std::min(before.head(first).minCoeff(), then.head(first).minCoeff()),
              before.tail(4 - first).maxCoeff() + distance - 1e-9)
        << trial;
  }
}

// By hand: it comes over the triangle's slanting edge, and is as high above it all the time.
TEST(Approach, of_a_vertex_that_slides_over_a_triangle_is_upright) {
  Passing pair;
  pair.start << -1, 0, 4, 1,  //
      0.1, 0, 0, 0,           //
      1, 0, 0, 4;
  pair.displacement.col(0) << 2.5, 0, 0;
  EXPECT_TRUE(pair.apart().isApprox(Vector3d(0, 0.1, 0)));
}

// What both go together makes no difference.
TEST(Approach, heeds_only_what_the_features_move_differently) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 100; ++trial) {
    Passing pair = random_passing(random);
    const Vector3d apart = pair.apart();
    pair.displacement.colwise() += Vector3d(3, -1, 2);
    EXPECT_TRUE(pair.apart().isApprox(apart, 1e-6)) << trial;
  }
}

}  // namespace ribbon::approach_test
