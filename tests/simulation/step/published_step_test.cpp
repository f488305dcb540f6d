#include "simulation/step/published_step.h"

#include <gtest/gtest.h>

#include "simulation/published/planted_penetrations.h"

namespace ribbon::published_step_test {

using Eigen::Matrix3Xd;

constexpr RibbonGrid grid{21, 5};
constexpr RestSize size{grid, 20, 4};  // edges of 1 m: contact from 0.1 m on
constexpr double step_s = 0.1;

Cloth cloth_at(const Matrix3Xd& positions) {
  return {positions, Matrix3Xd::Zero(3, grid.particle_count()), 1};
}

// Springs are not asked: what they would do is done to the cloth by hand.
PublishedStep step() {
  Scene scene;
  scene.contact = ContactMethod::paper;
  scene.springs = {.stretch = 1, .shear = 1};
  scene.time.step_s = step_s;
  return {scene, size, 1};
}

// It falls 1 m in the step, from 0.5 m over the floor, and is thrown back with a tenth of its
// speed.
TEST(PublishedStep, what_would_pass_the_floor_is_left_before_it_and_thrown_back) {
  OverFloor planted = ribbon_over_floor(grid, -0.5);
  Cloth cloth = cloth_at(planted.positions);
  cloth.velocities.row(1).setConstant(-10);
  cloth.positions += step_s * cloth.velocities;
  const StepReport report = step().correct(planted.positions, planted.bodies, cloth);
  EXPECT_EQ(report.recovery_iterations, 0);
  EXPECT_EQ(report.penetrating_edges, 0);
  EXPECT_GT(cloth.positions.row(1).minCoeff(), -0.5);
  EXPECT_NEAR(cloth.velocities.row(1).mean(), 1, 0.3);
}

// By hand: the last row is 0.5 m too far, of which 0.4 m are corrected, and that within the step.
TEST(PublishedStep, what_is_too_long_is_corrected_and_its_velocity_with_it) {
  const Matrix3Xd flat = flat_ribbon(grid);
  Bodies bodies = ribbon_alone(grid);
  Cloth cloth = cloth_at(flat);
  cloth.positions.rightCols(grid.across).row(0).array() += 0.5;
  EXPECT_FALSE(step().correct(flat, bodies, cloth).is_over_aimed);
  EXPECT_LE(cloth.positions.col(grid.particle(20, 2)).x(),
            cloth.positions.col(grid.particle(19, 2)).x() + 1.1 + 1e-9);
  EXPECT_LT(cloth.velocities.col(grid.particle(20, 2)).x(), 0);
  EXPECT_GT(cloth.velocities.col(grid.particle(19, 2)).x(), 0);
}

// Strain is corrected whatever is in the way; what that pushes through something is moved out
// again.
TEST(PublishedStep, recovers_from_what_is_left_penetrating) {
  OverFloor planted = ribbon_over_floor(grid, -0.5);
  planted.positions(1, grid.particle(10, 2)) = -0.7;
  Cloth cloth = cloth_at(planted.positions);
  const StepReport report = step().correct(planted.positions, planted.bodies, cloth);
  EXPECT_GT(report.recovery_iterations, 0);
  EXPECT_EQ(report.penetrating_edges, 0);
  EXPECT_GT(cloth.positions(1, grid.particle(10, 2)), -0.5);
}

}  // namespace ribbon::published_step_test
