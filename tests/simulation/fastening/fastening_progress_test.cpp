#include "simulation/fastening/fastening_progress.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/published/planted_penetrations.h"

namespace ribbon::fastening_progress_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

const RibbonGrid grid{10, 2};
constexpr double step_s = 0.01;
constexpr double air_per_s = 5;

// Away from the middle at 0.5 m/s.
Matrix3Xd command() {
  Matrix3Xd result = Matrix3Xd::Zero(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p) result(0, p) = grid.row(p) < 5 ? -0.5 : 0.5;
  return result;
}

class Progress : public testing::Test {
 protected:
  // `steps` steps in which the halves go at these speeds, m/s, along their commands.
  void go(int steps, double first_m_s, double second_m_s) {
    Matrix3Xd moved = command() / 0.5 * step_s;
    moved.leftCols(10) *= first_m_s;
    moved.rightCols(10) *= second_m_s;
    for (int step = 0; step < steps; ++step) progress_.add(command(), at_, at_ + moved);
  }

  Matrix3Xd at_ = flat_ribbon(grid);
  FasteningProgress progress_{grid, halves(grid), step_s, air_per_s};
};

TEST_F(Progress, knows_a_standstill_after_one_step_longer_than_it_remembers) {
  for (const double long_step_s : {3.0, 1e12}) {
    FasteningProgress progress(grid, halves(grid), long_step_s, air_per_s);
    progress.add(command(), at_, at_);
    EXPECT_TRUE(progress.is_at_standstill());
    EXPECT_EQ(progress.recent(), 0);
    progress.add(command(), at_, at_ + long_step_s * command());
    EXPECT_NEAR(progress.recent(), 1, 1e-6);
  }
}

TEST_F(Progress, is_1_before_anything_was_commanded) {
  EXPECT_EQ(progress_.recent(), 1);
  progress_.add(Matrix3Xd::Zero(3, grid.particle_count()), at_, at_);
  EXPECT_EQ(progress_.recent(), 1);
}

// By hand: v' = a (c - v) has v(t) = c (1 - exp(-a t)), and its distance is c (t - (1 - exp(-a t))
// / a).
TEST_F(Progress, of_free_particles_is_1_from_the_first_step_on) {
  const auto travel_s = [](double t) { return t + std::expm1(-air_per_s * t) / air_per_s; };
  for (int step = 0; step < 50; ++step) {
    const Matrix3Xd moved = command() * (travel_s((step + 1) * step_s) - travel_s(step * step_s));
    progress_.add(command(), at_, at_ + moved);
    ASSERT_NEAR(progress_.recent(), 1, 1e-9) << step;
  }
}

TEST_F(Progress, forgets_after_two_seconds) {
  go(200, 0.5, 0.5);
  go(100, 0, 0);
  EXPECT_NEAR(progress_.recent(), 0.5, 0.01);
  go(100, 0, 0);
  EXPECT_EQ(progress_.recent(), 0);
}

TEST_F(Progress, knows_a_standstill_after_two_seconds) {
  go(199, 0, 0);
  EXPECT_EQ(progress_.recent(), 0);
  EXPECT_FALSE(progress_.is_at_standstill());
  go(1, 0, 0);
  EXPECT_TRUE(progress_.is_at_standstill());
}

TEST_F(Progress, is_at_no_standstill_while_one_half_is_drawn_back) {
  go(400, 0, -0.1);
  EXPECT_EQ(progress_.recent(), 0);
  EXPECT_FALSE(progress_.is_at_standstill());
}

// The row in the middle is drawn to neither side.
TEST_F(Progress, is_that_of_those_who_are_told_to_go) {
  FasteningProgress progress(grid, {0, 0, 0, 0, 0, 1, -1, -1, -1, -1}, step_s, air_per_s);
  Matrix3Xd first = command();
  first.rightCols(10).setZero();
  for (int step = 0; step < 300; ++step) progress.add(first, at_, at_);
  EXPECT_EQ(progress.recent(), 0);
  EXPECT_TRUE(progress.is_at_standstill());
}

TEST_F(Progress, the_faster_half_counts) {
  go(400, 0.05, 0.2);
  EXPECT_NEAR(progress_.recent(), 0.4, 1e-3);
  go(400, 0.3, -0.3);
  EXPECT_NEAR(progress_.recent(), 0.6, 1e-3) << "it slides through its knot";
}

TEST_F(Progress, falls_below_0_when_the_ribbon_draws_the_hands_back) {
  go(400, -0.05, -0.1);
  EXPECT_NEAR(progress_.recent(), -0.1, 1e-3);
}

TEST_F(Progress, only_motion_along_the_force_counts) {
  for (int step = 0; step < 300; ++step)
    progress_.add(command(), at_, at_.colwise() + Vector3d(0, 0.1, 0.1));
  EXPECT_EQ(progress_.recent(), 0);
}

TEST(FasteningProgress, knows_two_seconds_for_any_step) {
  for (const double tried_s : {1e-12, 1e-3, 0.013, 0.3, 5.0}) {
    FasteningProgress progress(grid, halves(grid), tried_s, air_per_s);
    const Matrix3Xd at = flat_ribbon(grid);
    for (int step = 0; step < 2200 && !progress.is_at_standstill(); ++step)
      progress.add(command(), at, at);
    EXPECT_EQ(progress.is_at_standstill(), tried_s > 1e-6) << tried_s;
    EXPECT_EQ(progress.recent(), 0) << tried_s;
  }
}

}  // namespace ribbon::fastening_progress_test
