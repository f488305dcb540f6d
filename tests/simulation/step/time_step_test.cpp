#include "simulation/step/time_step.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/loop_scene.h"
#include "simulation/published/recovery.h"
#include "simulation/step/gated_step.h"
#include "simulation/step/published_step.h"

namespace ribbon::time_step_test {

using Eigen::Matrix3Xd;

struct Band {
  Scene scene = scene_of_loop();
  RibbonMesh mesh = mesh_of_loop(scene);
  Bodies bodies{mesh.grid, std::nullopt};
  Cloth cloth{mesh.positions, Matrix3Xd::Zero(3, mesh.positions.cols()), 0.001};

  GatedStep step(double fraction_of_width) {
    const RestSize size = mesh.size().narrowed(fraction_of_width);
    return {scene, size, contact_lengths(scene, size), cloth.particle_mass_kg};
  }
};

TEST(TimeStep, a_step_moves_with_the_force_and_gains_speed) {
  Band band;
  band.scene.time.integrator = IntegrationMethod::rk4;
  GatedStep step = band.step(1);
  Matrix3Xd force = Matrix3Xd::Zero(3, band.mesh.positions.cols());
  force.row(1).setConstant(0.01);
  EXPECT_EQ(step.advance_under(force, band.bodies, band.cloth).recovery_iterations, 0);
  // Every particle is pushed alike, so the springs do not resist: a = 10 m/s^2 for 10 ms, and a
  // little less for the air.
  const Matrix3Xd moved = band.cloth.positions - band.mesh.positions;
  EXPECT_NEAR(moved.row(1).mean(), 0.5 * 10 * 0.01 * 0.01, 1e-5);
  EXPECT_NEAR(band.cloth.velocities.row(1).mean(), 0.1, 3e-3);
}

TEST(TimeStep, a_move_gets_as_far_as_contact_lets_and_ends_at_rest) {
  Band band;
  GatedStep step = band.step(1);
  // All of the band is to be on one spot.
  const Matrix3Xd spot = Matrix3Xd::Zero(3, band.mesh.positions.cols());
  step.move(spot, band.bodies, band.cloth);
  EXPECT_GT((band.cloth.positions - band.mesh.positions).colwise().norm().maxCoeff(), 1e-3);
  EXPECT_EQ(count_penetrating_edges(band.bodies, band.cloth.positions), 0);
  EXPECT_EQ(band.cloth.velocities.cwiseAbs().maxCoeff(), 0);
}

TEST(TimeStep, settles_to_the_width_that_it_was_made_for) {
  Band band;
  GatedStep step = band.step(0.5);
  step.settle(50, band.bodies, band.cloth);
  const double across_m = 0.5 * band.mesh.width_m / (band.mesh.grid.across - 1);
  const int middle = band.mesh.grid.particle(60, 1);
  const auto& positions = band.cloth.positions;
  EXPECT_NEAR((positions.col(middle + 1) - positions.col(middle)).norm(), across_m,
              0.11 * across_m);
}

TEST(TimeStep, stiffer_springs_divide_the_step_into_more_parts) {
  Band band;
  const int few = band.step(1).integrator().substeps();
  band.scene.springs.stretch *= 100;
  EXPECT_GT(band.step(1).integrator().substeps(), 3 * few);
}

// Into as many parts as the implicit scheme divides it for a band that flies off and turns.
int parts_of_a_step(double speed_m_s, double turn_rad_s) {
  Band band;
  band.scene.time.integrator = IntegrationMethod::implicit;
  GatedStep step = band.step(1);
  band.cloth.velocities.row(0).setConstant(speed_m_s);
  band.cloth.velocities.row(1) += turn_rad_s * band.cloth.positions.row(2);
  band.cloth.velocities.row(2) -= turn_rad_s * band.cloth.positions.row(1);
  step.take(nullptr, band.bodies, band.cloth);
  return step.integrator().substeps();
}

TEST(TimeStep, of_the_implicit_scheme_is_divided_where_neighbours_move_differently) {
  EXPECT_EQ(parts_of_a_step(0, 0), 1);
  EXPECT_EQ(parts_of_a_step(20, 0), 1);
  EXPECT_EQ(parts_of_a_step(0, 1), 1);  // 1 % of an edge in a step
  EXPECT_GE(parts_of_a_step(0, 10), 2);
  EXPECT_EQ(parts_of_a_step(0, 100), 8);
}

TEST(TimeStep, guarantees_the_limit_of_strain_where_the_scene_wants_the_gate) {
  Band band;
  const RestSize size = band.mesh.size();
  for (const ContactMethod contact : {ContactMethod::gate, ContactMethod::paper}) {
    band.scene.contact = contact;
    const auto step = create_time_step(band.scene, size, contact_lengths(band.scene, size), 0.001);
    EXPECT_EQ(step->guaranteed_strain(), contact == ContactMethod::gate ? 0.1 : 0);
    EXPECT_EQ(std::isfinite(step->held_strain()), contact == ContactMethod::gate);
  }
}

}  // namespace ribbon::time_step_test
