#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "simulation/published/planted_penetrations.h"
#include "simulation/state/edge_strain.h"
#include "simulation/step/post_step.h"
#include "simulation/truncation/surroundings.h"

namespace ribbon::gated_post_step_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr RibbonGrid grid{21, 5};
constexpr RestSize size{grid, 20, 4};  // edges of 1 m: a hard gap of 0.05, contact from 0.2 m on
constexpr double step_s = 0.1;

Cloth cloth_at(const Matrix3Xd& positions) {
  return {positions, Matrix3Xd::Zero(3, grid.particle_count()), 1};
}

// One step at the cloth's velocities.
void drift(PostStep& post_step, Cloth& cloth) {
  const Matrix3Xd before = cloth.positions;
  cloth.positions.leftCols(grid.particle_count()) += step_s * cloth.velocities;
  post_step.correct(before, cloth);
}

double smallest_height(const Cloth& cloth) {
  return cloth.positions.row(1).leftCols(grid.particle_count()).minCoeff();
}

TEST(GatedPostStep, a_sheet_that_falls_comes_to_rest_over_the_floor) {
  OverFloor planted = ribbon_over_floor(grid, -1);
  Cloth cloth = cloth_at(planted.positions);
  StageClock clock;
  const auto post_step = gated_post_step(planted.bodies, {.size = size, .step_s = step_s}, clock);
  for (int step = 0; step < 30; ++step) {
    cloth.velocities.row(1).array() -= 1;
    drift(*post_step, cloth);
    ASSERT_GE(smallest_height(cloth), -1 + 0.05) << step;
  }
  EXPECT_LT(smallest_height(cloth), -1 + 0.3);
}

TEST(GatedPostStep, nothing_passes_however_far_the_wish_lies_beyond) {
  OverFloor planted = ribbon_over_floor(grid, -0.3);
  Cloth cloth = cloth_at(planted.positions);
  StageClock clock;
  const auto post_step = gated_post_step(planted.bodies, {.size = size, .step_s = step_s}, clock);
  for (int round = 0; round < 20; ++round) {
    const Matrix3Xd before = cloth.positions;
    cloth.positions.row(1).leftCols(grid.particle_count()).array() -= 3;
    post_step->correct(before, cloth);
    ASSERT_GE(smallest_height(cloth), -0.3 + 0.05 - 1e-12) << round;
  }
}

TEST(GatedPostStep, tells_how_many_particles_the_gate_held_back) {
  OverFloor planted = ribbon_over_floor(grid, -0.3);
  Cloth cloth = cloth_at(planted.positions);
  StageClock clock;
  const auto post_step = gated_post_step(planted.bodies, {.size = size, .step_s = step_s}, clock);
  const Matrix3Xd before = cloth.positions;
  EXPECT_EQ(post_step->correct(before, cloth).held_back, 0);
  // No way is longer than four edges, however free it is.
  cloth.positions.row(0).leftCols(grid.particle_count()).array() += 30;
  EXPECT_EQ(post_step->correct(before, cloth).held_back, grid.particle_count());
}

// Both ends are pulled outward while all of it is pressed on the floor. Rounded by 0.01 m, what is
// recorded differs by up to 3.5 % of an edge more.
TEST(GatedPostStep, what_is_pulled_against_contact_stays_within_the_strain_limit_as_recorded) {
  for (const double rounding_m : {0.0, 0.01}) {
    OverFloor planted = ribbon_over_floor(grid, -0.3);
    Cloth cloth = cloth_at(planted.positions);
    StageClock clock;
    const auto post_step = gated_post_step(
        planted.bodies, {.size = size, .step_s = step_s, .rounding_m = rounding_m}, clock);
    const double begun_m = cloth.positions.row(0).leftCols(grid.particle_count()).maxCoeff();
    for (int step = 0; step < 50; ++step) {
      for (int p = 0; p < grid.particle_count(); ++p) {
        cloth.velocities(0, p) += grid.row(p) > 15 ? 1 : grid.row(p) < 5 ? -1 : 0;
        cloth.velocities(1, p) -= 0.5;
      }
      drift(*post_step, cloth);
      ASSERT_LE(worst_strain(spring_network(size, {.stretch = 1, .shear = 1}), cloth.positions) +
                    2 * std::sqrt(3) * rounding_m,
                0.1)
          << step;
      ASSERT_GE(smallest_height(cloth), -1 + 0.05) << step;
    }
    EXPECT_GT(cloth.positions.row(0).leftCols(grid.particle_count()).maxCoeff(), begun_m + 0.5);
  }
}

// By hand: each step adds 1 m/s down, which contact takes away again, plus a tenth: friction takes
// about 0.3 m/s of the 5 m/s along the floor in each step, none takes nothing.
TEST(GatedPostStep, friction_slows_what_slides_under_pressure) {
  for (const double friction : {0.0, 0.3}) {
    OverFloor planted = ribbon_over_floor(grid, -0.15);
    Cloth cloth = cloth_at(planted.positions);
    cloth.velocities.row(0).setConstant(5);
    StageClock clock;
    const auto post_step = gated_post_step(
        planted.bodies, {.size = size, .step_s = step_s, .friction = friction}, clock);
    for (int step = 0; step < 8; ++step) {
      cloth.velocities.row(1).array() -= 1;
      drift(*post_step, cloth);
    }
    const double slowed_m_s = 5 - cloth.velocities.row(0).mean();
    if (friction == 0)
      EXPECT_NEAR(slowed_m_s, 0, 1e-9);
    else
      EXPECT_NEAR(slowed_m_s, 8 * 0.3, 0.8);
  }
}

// The smallest distance between features at least five rows apart, at most 1 m.
double gap_between_layers(Bodies& bodies, const Matrix3Xd& x) {
  const SurveyLengths lengths{.reach_m = 1, .slack_m = 0, .longest_way_m = 0};
  const Surroundings near = survey(bodies, lengths, x, x);
  double smallest = 1;
  for (std::size_t i = 0; i < near.pairs.size(); ++i) {
    const auto& v = near.pairs[i].vertices;
    if (std::abs(grid.row(v.front()) - grid.row(v.back())) >= 5)
      smallest = std::min(smallest, near.distances_m[i]);
  }
  return smallest;
}

TEST(GatedPostStep, thick_layers_part_to_their_thickness_and_are_not_pressed_under_half_of_it) {
  const Matrix3Xd start = folded_ribbon(grid, 0.4);
  Bodies bodies = ribbon_alone(grid);
  Cloth cloth = cloth_at(start);
  StageClock clock;
  const auto post_step =
      gated_post_step(bodies, {.size = size, .step_s = step_s, .thickness_m = 0.6}, clock);
  EXPECT_NEAR(gap_between_layers(bodies, cloth.positions), 0.4, 0.01);
  for (int step = 0; step < 10; ++step) drift(*post_step, cloth);
  EXPECT_NEAR(gap_between_layers(bodies, cloth.positions), 0.6, 0.05);
  double closest = 1;
  for (int step = 0; step < 20; ++step) {
    for (int p = 0; p < grid.particle_count(); ++p)
      cloth.velocities(1, p) += grid.row(p) < 10 ? 12 : -12;
    drift(*post_step, cloth);
    closest = std::min(closest, gap_between_layers(bodies, cloth.positions));
  }
  EXPECT_GE(closest, 0.3 - 1e-9);
  EXPECT_LT(closest, 0.55);
}

TEST(GatedPostStep, flat_neighbours_are_at_rest_however_thick_the_cloth) {
  const Matrix3Xd flat = flat_ribbon(grid);
  Bodies bodies = ribbon_alone(grid);
  Cloth cloth = cloth_at(flat);
  StageClock clock;
  const auto post_step =
      gated_post_step(bodies, {.size = size, .step_s = step_s, .thickness_m = 3}, clock);
  drift(*post_step, cloth);
  EXPECT_EQ(cloth.positions, flat);
}

}  // namespace ribbon::gated_post_step_test
