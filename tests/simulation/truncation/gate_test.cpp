#include "simulation/truncation/gate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "parallel/parallel.h"
#include "simulation/detection/closest_weights.h"
#include "simulation/detection/swept_pairs.h"
#include "simulation/detection/vertex_ranges.h"
#include "simulation/published/planted_penetrations.h"
#include "simulation/published/recovery.h"

namespace ribbon::gate_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Corners = Eigen::Matrix<double, 3, 4>;

double smallest_gap_m(Bodies& bodies, const Matrix3Xd& x, double query_m) {
  double smallest = query_m;
  for (const FeaturePair& pair : pairs_within_ranges(bodies, vertex_ranges(x, x), query_m)) {
    const Corners x_pair = corners(pair, x);
    smallest = std::min(smallest, (x_pair * closest_weights(pair.kind, x_pair)).norm());
  }
  return smallest;
}

// Cloth without thickness.
PairGaps thin(const Bodies& bodies, double hard_m) {
  return {{bodies.grid, 1, 1}, {.hard_m = hard_m, .contact_m = hard_m}};
}

// Detects, around stragglers again as long as there are any, and passes.
Passage pass(Bodies& bodies, double min_gap_m, const Matrix3Xd& wished, Matrix3Xd& x) {
  const SurveyLengths lengths{.reach_m = 0.05, .slack_m = 0.1, .longest_way_m = 100};
  Surroundings surroundings = survey(bodies, lengths, x, wished);
  while (true) {
    Passage passage = pass_gate(surroundings, thin(bodies, min_gap_m), wished, x);
    if (passage.stragglers.empty()) return passage;
    widen(passage.stragglers, Widening::onward_and_back, bodies, lengths, wished, surroundings);
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
  Bodies bodies = ribbon_alone(grid);
  std::mt19937 random(5);
  int held_back = 0;
  for (int throw_number = 0; throw_number < 60; ++throw_number) {
    held_back += pass(bodies, 0.02, thrown(grid, x, random), x).held_back;
    ASSERT_EQ(count_penetrating_edges(bodies, x), 0) << throw_number;
    ASSERT_GE(smallest_gap_m(bodies, x, 0.05), 0.02 - 1e-12) << throw_number;
  }
  EXPECT_GT(held_back, 100);
}

TEST(Gate, without_it_the_first_throw_intersects) {
  const RibbonGrid grid{21, 5};
  const Matrix3Xd x = folded_ribbon(grid, 0.5);
  Bodies bodies = ribbon_alone(grid);
  std::mt19937 random(5);
  EXPECT_GT(count_penetrating_edges(bodies, thrown(grid, x, random)), 0);
}

TEST(Gate, lets_a_sheet_slide_along_another_freely) {
  const RibbonGrid grid{9, 5};
  OverFloor planted = ribbon_over_floor(grid, -0.02);
  Matrix3Xd wished = planted.positions;
  wished.leftCols(grid.particle_count()).colwise() += Vector3d(0.3, 0, 0.2);
  Matrix3Xd x = planted.positions;
  EXPECT_EQ(pass(planted.bodies, 0.01, wished, x).held_back, 0);
  EXPECT_EQ(x, wished);
}

TEST(Gate, one_jammed_pair_does_not_stop_the_rest) {
  const RibbonGrid grid{9, 5};
  OverFloor planted = ribbon_over_floor(grid, -1);
  Matrix3Xd wished = planted.positions;
  wished.row(1).leftCols(grid.particle_count()).array() += 0.5;
  wished(1, 0) = -5;
  Matrix3Xd x = planted.positions;
  EXPECT_GE(pass(planted.bodies, 0.01, wished, x).held_back, 1);
  EXPECT_GT(x(1, 0), -1);
  EXPECT_EQ(x.col(grid.particle(8, 4)), wished.col(grid.particle(8, 4)));
}

// One survey serves many passages, whatever they wish: what leaves its range is held back.
TEST(Gate, keeps_the_gap_over_many_passages_within_one_survey) {
  const RibbonGrid grid{21, 5};
  Matrix3Xd x = folded_ribbon(grid, 0.5);
  Bodies bodies = ribbon_alone(grid);
  const SurveyLengths lengths{.reach_m = 0.05, .slack_m = 0.3, .longest_way_m = 100};
  const Surroundings surroundings = survey(bodies, lengths, x, x);
  std::mt19937 random(6);
  for (int throw_number = 0; throw_number < 60; ++throw_number) {
    pass_gate(surroundings, thin(bodies, 0.02), thrown(grid, x, random), x);
    ASSERT_TRUE(vertices_outside(surroundings, x).empty());
    ASSERT_EQ(count_penetrating_edges(bodies, x), 0) << throw_number;
    ASSERT_GE(smallest_gap_m(bodies, x, 0.05), 0.02 - 1e-12) << throw_number;
  }
}

// Two close layers fly off together, further than the gap between them: nothing is in the way of
// either, but when the front one is stopped the other must stop, too.
TEST(Gate, layers_that_fly_together_are_free_until_one_is_stopped) {
  const RibbonGrid grid{21, 5};
  const Matrix3Xd start = folded_ribbon(grid, 0.5);
  Bodies bodies = ribbon_alone(grid);
  Matrix3Xd wished = start;
  wished.row(1).array() += 3;
  Matrix3Xd x = start;
  EXPECT_EQ(pass(bodies, 0.02, wished, x).held_back, 0);
  EXPECT_EQ(x, wished);

  const int stopped = grid.particle(20, 2);
  const auto is_up = start(1, stopped) > start(1, grid.particle(0, 2));
  const int front = is_up ? stopped : grid.particle(0, 2);
  wished.col(front) = start.col(front);
  x = start;
  EXPECT_GT(pass(bodies, 0.02, wished, x).held_back, 1);
  EXPECT_EQ(x.col(front), start.col(front));
  EXPECT_EQ(count_penetrating_edges(bodies, x), 0);
  EXPECT_GE(smallest_gap_m(bodies, x, 0.05), 0.02 - 1e-12);
}

// All of a fast sheet is stopped early on its way through a floor, where the detection around its
// flight did not expect it.
TEST(Gate, stragglers_of_a_fast_sheet_are_surveyed_and_let_through_as_far_as_they_may) {
  const RibbonGrid grid{21, 5};
  OverFloor planted = ribbon_over_floor(grid, -1);
  Matrix3Xd wished = planted.positions;
  wished.row(0).leftCols(grid.particle_count()).array() += 8;
  wished.row(1).leftCols(grid.particle_count()).array() -= 2;
  const SurveyLengths lengths{.reach_m = 0.05, .slack_m = 0.1, .longest_way_m = 100};
  Matrix3Xd x = planted.positions;
  const Surroundings surroundings = survey(planted.bodies, lengths, x, wished);
  const PairGaps gaps = thin(planted.bodies, 0.02);
  EXPECT_EQ(pass_gate(surroundings, gaps, wished, x).stragglers.size(),
            static_cast<std::size_t>(grid.particle_count()));
  const Passage passage = pass(planted.bodies, 0.02, wished, x);
  EXPECT_EQ(passage.held_back, grid.particle_count());
  EXPECT_GT(passage.farthest_m, 1);
  EXPECT_GE(x.row(1).leftCols(grid.particle_count()).minCoeff(), -1 + 0.02 - 1e-12);
}

TEST(Gate, gives_the_same_bits_for_any_number_of_threads) {
  const RibbonGrid grid{121, 9};
  std::vector<Matrix3Xd> answers;
  for (const int threads : {1, 2, 5}) {
    set_thread_limit(threads);
    Matrix3Xd x = folded_ribbon(grid, 0.5);
    Bodies bodies = ribbon_alone(grid);
    Matrix3Xd wished = x;
    for (int p = 0; p < grid.particle_count(); ++p)
      wished.col(p) += 0.4 * Vector3d(std::sin(p), std::cos(3 * p), std::sin(7 * p));
    pass(bodies, 0.02, wished, x);
    answers.push_back(x);
  }
  set_thread_limit(0);
  EXPECT_EQ(answers[0], answers[1]);
  EXPECT_EQ(answers[0], answers[2]);
}

}  // namespace ribbon::gate_test
