#include "simulation/truncation/contact_candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "geometry/vectors.h"
#include "simulation/detection/closest_weights.h"
#include "simulation/detection/swept_pairs.h"
#include "simulation/detection/vertex_ranges.h"
#include "simulation/published/planted_penetrations.h"

namespace ribbon::contact_candidates_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double reach_m = 0.2;

Matrix3Xd kicked(const Matrix3Xd& x, double size, std::mt19937& random) {
  std::normal_distribution<double> kick(0, size);
  Matrix3Xd result = x;
  for (double& value : result.reshaped()) value += kick(random);
  return result;
}

std::vector<int> particles_outside(const ContactCandidates& candidates, const Matrix3Xd& target) {
  std::vector<int> outside;
  find_particles_outside(candidates, target, outside);
  return outside;
}

using Key = std::pair<FeaturePair::Kind, std::array<int, 4>>;

std::set<Key> listed_in(const ContactCandidates& candidates) {
  EXPECT_EQ(candidates.pairs.size(), candidates.distances_m.size());
  EXPECT_EQ(candidates.pairs.size(), candidates.weights.size());
  std::set<Key> listed;
  for (const FeaturePair& pair : candidates.pairs)
    EXPECT_TRUE(listed.insert({pair.kind, pair.vertices}).second) << "listed twice";
  return listed;
}

// Wherever its vertices are inside their bounds, on the way or at its end, a pair within reach is
// on the list.
void expect_all_within_reach_are_listed(const ContactCandidates& candidates, Bodies bodies,
                                        std::mt19937& random, const PairReach& reach = {reach_m}) {
  const auto listed = listed_in(candidates);
  const auto reach_of = [&](const FeaturePair& pair) {
    return reach.of_pair ? reach.of_pair(pair) : reach.largest_m;
  };
  int within_reach = 0;
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<FeaturePair> close;
  for (int trial = 0; trial < 40; ++trial) {
    Matrix3Xd end = candidates.from;
    for (int p = 0; p < bodies.grid.particle_count(); ++p) {
      const Box& bound = candidates.bounds[p].end;
      for (int c = 0; c < 3; ++c)
        end(c, p) = bound.low[c] + part(random) * (bound.high[c] - bound.low[c]);
    }
    ASSERT_TRUE(particles_outside(candidates, end).empty());
    const double time = trial < 20 ? 1 : part(random);
    const Matrix3Xd x = candidates.from + time * (end - candidates.from);
    list_pairs_within_ranges(bodies, vertex_ranges(x, x), reach.largest_m, close);
    for (const FeaturePair& pair : close) {
      const auto c = corners(pair, x);
      if ((c * closest_weights(pair.kind, c)).norm() > reach_of(pair)) continue;
      ++within_reach;
      EXPECT_TRUE(listed.contains({pair.kind, pair.vertices}));
    }
  }
  EXPECT_GT(within_reach, 1000);
}

TEST(ContactCandidates, list_every_pair_that_comes_within_reach_inside_the_bounds) {
  auto [grid, from, bodies] = folded(0.5);
  std::mt19937 random(8);
  const BroadPhaseLengths lengths{.reach_m = reach_m, .slack_m = 0.2, .longest_way_m = 1};
  const ContactCandidates candidates =
      BroadPhase(lengths).detect(bodies, from, from, kicked(from, 0.2, random));
  expect_all_within_reach_are_listed(candidates, bodies, random);
}

// The folded ribbon as cloth so thick that its layers touch, and that all within two rows or
// columns of a particle are within it.
PairDistances thick_fold(const RibbonGrid& grid) {
  return {{grid, 20, 4}, {.min_separation_m = 0.01, .activation_m = 0.02, .thickness_m = 1.9}};
}

// Neighbours, of which the reach of thick cloth is full, are listed as far as they could touch.
TEST(ContactCandidates, of_thick_cloth_list_what_comes_within_its_own_reach) {
  auto [grid, from, bodies] = folded(1.5);
  std::mt19937 random(8);
  const PairDistances thick = thick_fold(grid);
  const PairReach reach = thick.activation_reach(0);
  const BroadPhaseLengths lengths{.reach_m = reach.largest_m, .slack_m = 0.1, .longest_way_m = 1};
  const Matrix3Xd target = kicked(from, 0.05, random);
  BroadPhase broad_phase(lengths, thick);
  const ContactCandidates candidates = broad_phase.detect(bodies, from, from, target);
  expect_all_within_reach_are_listed(candidates, bodies, random, reach);
  EXPECT_LT(3 * candidates.pairs.size(),
            2 * BroadPhase(lengths).detect(bodies, from, from, target).pairs.size());
  broad_phase.widen(std::vector<int>{2, 23, 60}, Widening::onward_and_back, bodies,
                    kicked(from, 0.5, random));
  expect_all_within_reach_are_listed(broad_phase.candidates(), bodies, random, reach);
}

// By hand: still, none approaches; of one particle that moves at once all its pairs do, within a
// reach that all are in.
TEST(ApproachingPairs, that_rest_are_found_only_where_asked_for) {
  auto [grid, from, bodies] = folded(0.1);
  const BroadPhaseLengths lengths{.reach_m = reach_m, .slack_m = 0, .longest_way_m = 1};
  const ContactCandidates still = BroadPhase(lengths).detect(bodies, from, from, from);
  Matrix3Xd displacement = Matrix3Xd::Zero(3, grid.particle_count());
  const auto found = [&, &from = from](RestingPairs resting) {
    return ApproachingPairs().find(still, from, displacement, {reach_m}, resting).size();
  };
  ASSERT_GT(still.pairs.size(), 100U);
  EXPECT_EQ(found(RestingPairs::found), still.pairs.size());
  EXPECT_EQ(found(RestingPairs::left_out), 0U);
  const int moving = still.pairs.front().vertices[3];
  displacement(1, moving) = 1e-9;
  std::size_t of_particle = 0;
  for (const FeaturePair& pair : still.pairs)
    of_particle += std::count(pair.vertices.begin(), pair.vertices.end(), moving) > 0 ? 1U : 0U;
  EXPECT_EQ(found(RestingPairs::found), still.pairs.size());
  EXPECT_EQ(found(RestingPairs::left_out), of_particle);
}

// None is left out that its straight way brings within its own reach.
TEST(ApproachingPairs, of_thick_cloth_are_those_that_come_within_their_own_reach) {
  auto [grid, from, bodies] = folded(1.5);
  std::mt19937 random(8);
  const PairDistances thick = thick_fold(grid);
  const PairReach reach = thick.min_separation_reach(1);
  const Matrix3Xd target = kicked(from, 0.2, random);
  const ContactCandidates candidates =
      BroadPhase({.reach_m = thick.largest_activation_m(), .slack_m = 0.1, .longest_way_m = 2},
                 thick)
          .detect(bodies, from, from, target);
  ApproachingPairs approaching;
  const std::vector<std::size_t> found =
      approaching.find(candidates, from, target - from, reach, RestingPairs::found);
  std::vector<char> is_found(candidates.pairs.size(), 0);
  for (const std::size_t i : found) is_found[i] = 1;
  int within_reach = 0;
  for (const double time : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Matrix3Xd x = from + time * (target - from);
    for (std::size_t i = 0; i < candidates.pairs.size(); ++i) {
      const FeaturePair& pair = candidates.pairs[i];
      const auto c = corners(pair, bodies.vertices(x));
      if ((c * closest_weights(pair.kind, c)).norm() > reach.of_pair(pair)) continue;
      ++within_reach;
      EXPECT_TRUE(is_found[i] != 0) << i << " at " << time;
    }
  }
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < candidates.pairs.size(); ++i)
    if (is_found[i] == 0) others.push_back(i);
  EXPECT_GT(within_reach, 30);
  EXPECT_LT(found.size(), candidates.pairs.size());
  EXPECT_TRUE(approaching.find_among(others, candidates, (target - from) / 1e9).empty());
}

TEST(ContactCandidates, of_thick_cloth_that_lies_flat_are_few) {
  const RibbonGrid grid{40, 8};
  const Matrix3Xd flat = flat_ribbon(grid);
  Bodies bodies = ribbon_alone(grid);
  const PairDistances thick(RestSize{grid, 39, 7},
                            {.min_separation_m = 0.01, .activation_m = 0.02, .thickness_m = 3});
  const BroadPhaseLengths lengths{
      .reach_m = thick.largest_activation_m(), .slack_m = 0.05, .longest_way_m = 1};
  const std::size_t uniform = BroadPhase(lengths).detect(bodies, flat, flat, flat).pairs.size();
  EXPECT_LT(20 * BroadPhase(lengths, thick).detect(bodies, flat, flat, flat).pairs.size(), uniform);
}

void expect_measured_at_the_detection(const ContactCandidates& candidates) {
  ASSERT_EQ(candidates.pairs.size(), candidates.distances_m.size());
  ASSERT_EQ(candidates.pairs.size(), candidates.weights.size());
  for (std::size_t i = 0; i < candidates.pairs.size(); ++i) {
    const auto c = corners(candidates.pairs[i], candidates.from);
    EXPECT_EQ(closest_weights(candidates.pairs[i].kind, c), candidates.weights[i]);
    EXPECT_EQ(length_of(weighted_sum(c, candidates.weights[i])), candidates.distances_m[i]);
  }
}

TEST(ContactCandidates, widened_around_some_particles_still_list_every_pair_once) {
  auto [grid, from, bodies] = folded(0.5);
  std::mt19937 random(8);
  const BroadPhaseLengths lengths{.reach_m = reach_m, .slack_m = 0.2, .longest_way_m = 1};
  BroadPhase broad_phase(lengths);
  const ContactCandidates& candidates =
      broad_phase.detect(bodies, from, from, kicked(from, 0.2, random));
  const std::size_t before = candidates.pairs.size();
  const Matrix3Xd farther = kicked(from, 0.5, random);
  const std::vector<int> some = {0, 1, 7, 23, 52, 77, 104};
  broad_phase.widen(some, Widening::onward, bodies, farther);
  for (const int p : some) {
    const MovingBox& bound = candidates.bounds[p];
    EXPECT_TRUE(bound.end.contains(farther.col(p)) || (farther - from).col(p).norm() > 1);
  }
  EXPECT_GT(candidates.pairs.size(), before);
  expect_all_within_reach_are_listed(candidates, bodies, random);
  const std::vector<int> back = {2, 23, 60};
  broad_phase.widen(back, Widening::onward_and_back, bodies, farther);
  for (const int p : back) EXPECT_TRUE(candidates.bounds[p].end.contains(from.col(p)));
  expect_measured_at_the_detection(candidates);
  expect_all_within_reach_are_listed(candidates, bodies, random);
}

TEST(ContactCandidates, know_the_closest_points_and_leave_far_pairs_out) {
  auto [grid, from, bodies] = folded(0.1);
  const BroadPhaseLengths lengths{.reach_m = reach_m, .slack_m = 0, .longest_way_m = 1};
  const ContactCandidates still = BroadPhase(lengths).detect(bodies, from, from, from);
  EXPECT_GT(still.pairs.size(), 100U);
  expect_measured_at_the_detection(still);
  for (const double distance_m : still.distances_m) EXPECT_LE(distance_m, reach_m);
}

TEST(ApproachingPairs, know_the_closest_points_wherever_the_particles_have_gone) {
  auto [grid, from, bodies] = folded(0.1);
  std::mt19937 random(8);
  const BroadPhaseLengths lengths{.reach_m = reach_m, .slack_m = 0.2, .longest_way_m = 1};
  const Matrix3Xd target = kicked(from, 0.1, random);
  const ContactCandidates candidates = BroadPhase(lengths).detect(bodies, from, from, target);
  EXPECT_GT(candidates.pairs.size(), 100U);
  ApproachingPairs approaching;
  for (const Matrix3Xd& x : {from, target}) {
    approaching.find(candidates, x, target - x, {reach_m}, RestingPairs::found);
    for (std::size_t i = 0; i < candidates.pairs.size(); ++i) {
      const auto c = corners(candidates.pairs[i], x);
      EXPECT_EQ(approaching.weights(i, candidates, c),
                closest_weights(candidates.pairs[i].kind, c));
    }
  }
}

TEST(ContactCandidates, a_target_on_the_moon_does_not_list_the_whole_ribbon) {
  const RibbonGrid grid{40, 4};
  const Matrix3Xd from = flat_ribbon(grid);
  Bodies bodies = ribbon_alone(grid);
  Matrix3Xd target = from;
  for (int p = 0; p < grid.particle_count(); ++p) target(0, p) += p % 2 == 0 ? 4e8 : -4e8;
  const BroadPhaseLengths lengths{.reach_m = reach_m, .slack_m = 0.1, .longest_way_m = 2};
  const ContactCandidates candidates = BroadPhase(lengths).detect(bodies, from, from, target);
  EXPECT_LT(candidates.pairs.size(), 100U * static_cast<unsigned>(grid.particle_count()));
  EXPECT_EQ(particles_outside(candidates, target).size(),
            static_cast<std::size_t>(grid.particle_count()));
}

TEST(ContactCandidates, pairs_that_fly_together_do_not_approach) {
  auto [grid, from, bodies] = folded(0.3);
  Matrix3Xd displacement = Matrix3Xd::Zero(3, grid.particle_count());
  displacement.row(1).setConstant(3);
  const BroadPhaseLengths lengths{.reach_m = reach_m, .slack_m = 0.1, .longest_way_m = 10};
  const ContactCandidates candidates =
      BroadPhase(lengths).detect(bodies, from, from, from + displacement);
  EXPECT_GT(candidates.pairs.size(), 100U);
  EXPECT_TRUE(ApproachingPairs()
                  .find(candidates, from, displacement, {reach_m}, RestingPairs::found)
                  .empty());
  // By hand: one particle that lags by its whole displacement approaches all that it is listed
  // with.
  const int lagging = grid.particle(10, 2);
  displacement.col(lagging).setZero();
  std::size_t of_particle = 0;
  for (const FeaturePair& pair : candidates.pairs)
    of_particle += std::count(pair.vertices.begin(), pair.vertices.end(), lagging) > 0 ? 1U : 0U;
  EXPECT_EQ(ApproachingPairs()
                .find(candidates, from, displacement, {reach_m}, RestingPairs::found)
                .size(),
            of_particle);
}

}  // namespace ribbon::contact_candidates_test
