#include "simulation/integration/lbfgs_history.h"

#include <gtest/gtest.h>

#include <random>

#include "parallel/any_threads.h"

namespace ribbon::lbfgs_history_test {

using Eigen::MatrixX3d;

constexpr RibbonGrid grid{500, 6};  // more than one run of particles

// A parabola whose second derivatives the matrix knows but roughly.
MatrixX3d gradient_at(const MatrixX3d& displacement) {
  MatrixX3d gradient = displacement - MatrixX3d::Ones(grid.particle_count(), 3);
  for (int i = 0; i < grid.particle_count(); ++i) gradient.row(i) *= 1 + i % 7;
  return gradient;
}

LbfgsHistory::Place at(const MatrixX3d& displacement) {
  return {displacement, gradient_at(displacement)};
}

QuasiNewtonMatrix inertia_alone() {
  QuasiNewtonMatrix matrix({.grid = grid}, 2);
  matrix.factor(MatrixX3d::Zero(grid.particle_count(), 3));
  return matrix;
}

class Places {
 public:
  LbfgsHistory::Place next() {
    MatrixX3d displacement(grid.particle_count(), 3);
    for (double& value : displacement.reshaped()) value = between_(random_);
    return at(displacement);
  }

 private:
  std::mt19937 random_{3};
  std::uniform_real_distribution<double> between_{-1, 1};
};

TEST(LbfgsHistory, knows_nothing_but_the_matrix_at_first) {
  QuasiNewtonMatrix matrix = inertia_alone();
  const MatrixX3d gradient = Places().next().gradient;
  MatrixX3d displacement;
  const double slope =
      LbfgsHistory(grid.particle_count()).toward_minimum(matrix, gradient, displacement);
  EXPECT_LT((displacement + gradient / 2).norm(), 1e-12);
  EXPECT_NEAR(slope, -gradient.squaredNorm() / 2, 1e-8);
}

// The condition by which it is defined, for any number of pairs.
TEST(LbfgsHistory, answers_the_newest_change_of_the_gradient_with_the_way_that_brought_it) {
  QuasiNewtonMatrix matrix = inertia_alone();
  LbfgsHistory history(grid.particle_count());
  Places places;
  LbfgsHistory::Place from = places.next();
  for (int pair = 0; pair < 8; ++pair) {
    const LbfgsHistory::Place to = places.next();
    history.add(from, to, 1e-8);
    MatrixX3d displacement;
    history.toward_minimum(matrix, from.gradient - to.gradient, displacement);
    EXPECT_LT((displacement - (to.displacement - from.displacement)).norm(), 1e-10) << pair;
    from = to;
  }
}

TEST(LbfgsHistory, leads_to_the_minimum_of_a_parabola) {
  QuasiNewtonMatrix matrix = inertia_alone();
  LbfgsHistory history(grid.particle_count());
  LbfgsHistory::Place here = at(MatrixX3d::Zero(grid.particle_count(), 3));
  for (int i = 0; i < 60; ++i) {
    MatrixX3d displacement;
    history.toward_minimum(matrix, here.gradient, displacement);
    const LbfgsHistory::Place next = at(here.displacement + displacement);
    history.add(here, next, 1e-8);
    here = next;
  }
  EXPECT_LT((here.displacement.array() - 1).matrix().norm(), 1e-10);
}

TEST(LbfgsHistory, leaves_out_ways_along_which_the_gradient_does_not_grow) {
  QuasiNewtonMatrix matrix = inertia_alone();
  LbfgsHistory history(grid.particle_count());
  Places places;
  for (int pair = 0; pair < 6; ++pair) history.add(places.next(), places.next(), 1e-8);
  const LbfgsHistory::Place from = places.next();
  LbfgsHistory::Place to = places.next();
  MatrixX3d expected;
  history.toward_minimum(matrix, from.gradient, expected);
  to.gradient = from.gradient - (to.displacement - from.displacement);
  history.add(from, to, 1e-8);
  MatrixX3d displacement;
  history.toward_minimum(matrix, from.gradient, displacement);
  EXPECT_EQ(displacement, expected);
  EXPECT_FALSE(history.empty());
}

TEST(LbfgsHistory, gives_the_same_bits_for_any_number_of_threads) {
  QuasiNewtonMatrix matrix = inertia_alone();
  same_for_any_threads([&] {
    LbfgsHistory history(grid.particle_count());
    Places places;
    for (int pair = 0; pair < 6; ++pair) history.add(places.next(), places.next(), 1e-8);
    MatrixX3d displacement;
    history.toward_minimum(matrix, places.next().gradient, displacement);
    return displacement;
  });
}

}  // namespace ribbon::lbfgs_history_test
