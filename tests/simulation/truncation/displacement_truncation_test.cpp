#include "simulation/truncation/displacement_truncation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "parallel/any_threads.h"
#include "simulation/detection/closest_weights.h"
#include "simulation/detection/swept_pairs.h"
#include "simulation/detection/vertex_ranges.h"
#include "simulation/published/planted_penetrations.h"
#include "simulation/published/recovery.h"

namespace ribbon::displacement_truncation_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Corners = Eigen::Matrix<double, 3, 4>;

double smallest_gap_m(Bodies& bodies, const Matrix3Xd& x, double query_m) {
  double smallest = query_m;
  std::vector<FeaturePair> close;
  list_pairs_within_ranges(bodies, vertex_ranges(x, x), query_m, close);
  for (const FeaturePair& pair : close) {
    const Corners x_pair = corners(pair, x);
    smallest = std::min(smallest, (x_pair * closest_weights(pair.kind, x_pair)).norm());
  }
  return smallest;
}

// Cloth without thickness.
PairDistances thin(const Bodies& bodies, double min_separation_m) {
  return {{bodies.grid, 1, 1},
          {.min_separation_m = min_separation_m, .activation_m = min_separation_m}};
}

// Detects, around stragglers again as long as there are any, and truncates.
TruncationReport truncate(Bodies& bodies, double min_separation_m, const Matrix3Xd& target,
                          Matrix3Xd& x) {
  const BroadPhaseLengths lengths{.reach_m = 0.05, .slack_m = 0.1, .longest_way_m = 100};
  BroadPhase broad_phase(lengths);
  broad_phase.detect(bodies, x, x, target);
  DisplacementTruncation truncation;
  while (true) {
    const TruncationReport& report = truncation.truncate(broad_phase.candidates(), bodies,
                                                         thin(bodies, min_separation_m), target, x);
    if (report.stragglers.empty()) return report;
    broad_phase.widen(report.stragglers, Widening::onward_and_back, bodies, target);
  }
}

// Where the particles of a folded ribbon would land: anywhere, and the halves toward each other.
Matrix3Xd thrown(const RibbonGrid& grid, const Matrix3Xd& x, std::mt19937& random) {
  std::normal_distribution<double> kick(0, 0.4);
  Matrix3Xd target = x;
  for (double& value : target.reshaped()) value += kick(random);
  for (int p = 0; p < grid.particle_count(); ++p) target(1, p) += grid.row(p) < 10 ? 0.4 : -0.4;
  return target;
}

TEST(DisplacementTruncation, a_ribbon_thrown_at_itself_never_comes_closer_than_the_gap) {
  auto [grid, x, bodies] = folded(0.5);
  std::mt19937 random(5);
  int truncated = 0;
  for (int throw_number = 0; throw_number < 60; ++throw_number) {
    truncated += truncate(bodies, 0.02, thrown(grid, x, random), x).truncated;
    ASSERT_EQ(count_penetrating_edges(bodies, x), 0) << throw_number;
    ASSERT_GE(smallest_gap_m(bodies, x, 0.05), 0.02 - 1e-12) << throw_number;
  }
  EXPECT_GT(truncated, 100);
}

TEST(DisplacementTruncation, without_it_the_first_throw_intersects) {
  auto [grid, x, bodies] = folded(0.5);
  std::mt19937 random(5);
  EXPECT_GT(count_penetrating_edges(bodies, thrown(grid, x, random)), 0);
}

TEST(DisplacementTruncation, lets_a_sheet_slide_along_another_freely) {
  const RibbonGrid grid{9, 5};
  OverFloor planted = ribbon_over_floor(grid, -0.02);
  Matrix3Xd target = planted.positions;
  target.colwise() += Vector3d(0.3, 0, 0.2);
  Matrix3Xd x = planted.positions;
  EXPECT_EQ(truncate(planted.bodies, 0.01, target, x).truncated, 0);
  EXPECT_EQ(x, target);
}

TEST(DisplacementTruncation, one_jammed_pair_does_not_stop_the_rest) {
  const RibbonGrid grid{9, 5};
  OverFloor planted = ribbon_over_floor(grid, -1);
  Matrix3Xd target = planted.positions;
  target.row(1).array() += 0.5;
  target(1, 0) = -5;
  Matrix3Xd x = planted.positions;
  EXPECT_GE(truncate(planted.bodies, 0.01, target, x).truncated, 1);
  EXPECT_GT(x(1, 0), -1);
  EXPECT_EQ(x.col(grid.particle(8, 4)), target.col(grid.particle(8, 4)));
}

// One detection serves many truncations, whatever the targets: what would leave its bound is
// truncated.
TEST(DisplacementTruncation, keeps_the_gap_many_times_within_one_detection) {
  auto [grid, x, bodies] = folded(0.5);
  const BroadPhaseLengths lengths{.reach_m = 0.05, .slack_m = 0.3, .longest_way_m = 100};
  const ContactCandidates candidates = BroadPhase(lengths).detect(bodies, x, x, x);
  DisplacementTruncation truncation;
  std::mt19937 random(6);
  for (int throw_number = 0; throw_number < 60; ++throw_number) {
    truncation.truncate(candidates, bodies, thin(bodies, 0.02), thrown(grid, x, random), x);
    std::vector<int> outside;
    find_particles_outside(candidates, x, outside);
    ASSERT_TRUE(outside.empty());
    ASSERT_EQ(count_penetrating_edges(bodies, x), 0) << throw_number;
    ASSERT_GE(smallest_gap_m(bodies, x, 0.05), 0.02 - 1e-12) << throw_number;
  }
}

// Two close layers fly off together, further than the gap between them: nothing is in the way of
// either, but when the front one is stopped the other must stop, too.
TEST(DisplacementTruncation, layers_that_fly_together_are_free_until_one_is_stopped) {
  auto [grid, start, bodies] = folded(0.5);
  Matrix3Xd target = start;
  target.row(1).array() += 3;
  Matrix3Xd x = start;
  EXPECT_EQ(truncate(bodies, 0.02, target, x).truncated, 0);
  EXPECT_EQ(x, target);

  const int stopped = grid.particle(20, 2);
  const auto is_up = start(1, stopped) > start(1, grid.particle(0, 2));
  const int front = is_up ? stopped : grid.particle(0, 2);
  target.col(front) = start.col(front);
  x = start;
  EXPECT_GT(truncate(bodies, 0.02, target, x).truncated, 1);
  EXPECT_EQ(x.col(front), start.col(front));
  EXPECT_EQ(count_penetrating_edges(bodies, x), 0);
  EXPECT_GE(smallest_gap_m(bodies, x, 0.05), 0.02 - 1e-12);
}

TEST(DisplacementTruncation, layers_that_fly_together_go_on_when_one_is_hardly_held_up) {
  const RibbonGrid grid{21, 5};
  const Matrix3Xd start = folded_ribbon(grid, 0.5);
  const int front = grid.particle(20, 2);
  Matrix3Xd peg(3, 3);
  peg << -0.1, 0.1, 0, 0, 0, 0, -0.1, -0.1, 0.2;
  peg.colwise() += start.col(front) + Vector3d(0, 2.9, 0);
  Bodies bodies{grid, ObstacleBody(Eigen::Vector3i(0, 1, 2), peg)};
  Matrix3Xd target = start;
  target.row(1).array() += 3;
  Matrix3Xd x = start;
  const int truncated = truncate(bodies, 0.02, target, x).truncated;
  EXPECT_GE(truncated, 1);
  EXPECT_LE(truncated, 9);  // the particle and its neighbours
  EXPECT_LT(x(1, front), peg(1, 0));
  EXPECT_EQ(x.col(grid.particle(0, 2)), target.col(grid.particle(0, 2)));
  EXPECT_EQ(count_penetrating_edges(bodies, x), 0);
  EXPECT_GE(smallest_gap_m(bodies, x, 0.05), 0.02 - 1e-12);
}

// All of a fast sheet is stopped early on its way through a floor, where the detection around its
// flight did not expect it.
TEST(DisplacementTruncation,
     stragglers_of_a_fast_sheet_are_detected_again_and_go_as_far_as_they_may) {
  const RibbonGrid grid{21, 5};
  OverFloor planted = ribbon_over_floor(grid, -1);
  Matrix3Xd target = planted.positions;
  target.row(0).array() += 8;
  target.row(1).array() -= 2;
  const BroadPhaseLengths lengths{.reach_m = 0.05, .slack_m = 0.1, .longest_way_m = 100};
  Matrix3Xd x = planted.positions;
  const ContactCandidates candidates = BroadPhase(lengths).detect(planted.bodies, x, x, target);
  const PairDistances distances = thin(planted.bodies, 0.02);
  DisplacementTruncation truncation;
  EXPECT_EQ(truncation.truncate(candidates, planted.bodies, distances, target, x).stragglers.size(),
            static_cast<std::size_t>(grid.particle_count()));
  const TruncationReport report = truncate(planted.bodies, 0.02, target, x);
  EXPECT_EQ(report.truncated, grid.particle_count());
  EXPECT_GT(report.farthest_m, 1);
  EXPECT_GE(x.row(1).minCoeff(), -1 + 0.02 - 1e-12);
}

TEST(DisplacementTruncation, gives_the_same_bits_for_any_number_of_threads) {
  const RibbonGrid grid{121, 9};
  same_for_any_threads([&] {
    Matrix3Xd x = folded_ribbon(grid, 0.5);
    Bodies bodies = ribbon_alone(grid);
    Matrix3Xd target = x;
    for (int p = 0; p < grid.particle_count(); ++p)
      target.col(p) += 0.4 * Vector3d(std::sin(p), std::cos(3 * p), std::sin(7 * p));
    truncate(bodies, 0.02, target, x);
    return x;
  });
}

}  // namespace ribbon::displacement_truncation_test
