#include "simulation/step/deformation.h"

#include <gtest/gtest.h>

#include "simulation/loop_scene.h"
#include "simulation/published/recovery.h"
#include "simulation/start/width_growth.h"

namespace ribbon::deformation_test {

using Eigen::Matrix3Xd;

struct Band {
  Scene scene = scene_of_loop();
  RibbonMesh mesh = mesh_of_loop(scene);
  Bodies bodies{mesh.grid, std::nullopt};
  Cloth cloth{mesh.positions, Matrix3Xd::Zero(3, mesh.positions.cols()), 0.001};

  Deformation deformation(double share_of_width) {
    return {scene, rest_size(mesh, share_of_width), cloth.particle_mass_kg, bodies};
  }
};

TEST(Deformation, a_step_moves_with_the_force_and_gains_speed) {
  Band band;
  band.scene.time.integrator = IntegrationMethod::rk4;
  Deformation deformation = band.deformation(1);
  Matrix3Xd force = Matrix3Xd::Zero(3, band.mesh.positions.cols());
  force.row(1).setConstant(0.01);
  EXPECT_EQ(deformation.step(force, band.cloth).recovery_iterations, 0);
  // Every particle is pushed alike, so the springs do not resist: a = 10 m/s^2 for 10 ms, and a
  // little less for the air.
  const Matrix3Xd moved = band.cloth.positions - band.mesh.positions;
  EXPECT_NEAR(moved.row(1).mean(), 0.5 * 10 * 0.01 * 0.01, 1e-5);
  EXPECT_NEAR(band.cloth.velocities.row(1).mean(), 0.1, 3e-3);
}

TEST(Deformation, a_move_gets_as_far_as_contact_lets_and_ends_at_rest) {
  Band band;
  Deformation deformation = band.deformation(1);
  // All of the band wishes to be on one spot.
  const Matrix3Xd spot = Matrix3Xd::Zero(3, band.mesh.positions.cols());
  deformation.move(spot, band.cloth);
  EXPECT_GT((band.cloth.positions - band.mesh.positions).colwise().norm().maxCoeff(), 1e-3);
  EXPECT_EQ(count_penetrating_edges(band.bodies, band.cloth.positions), 0);
  EXPECT_EQ(band.cloth.velocities.cwiseAbs().maxCoeff(), 0);
}

TEST(Deformation, settles_to_the_width_that_it_was_made_for) {
  Band band;
  Deformation deformation = band.deformation(0.5);
  deformation.settle(50, band.cloth);
  const double across_m = 0.5 * band.mesh.width_m / (band.mesh.grid.across - 1);
  const int middle = band.mesh.grid.particle(60, 1);
  const auto& positions = band.cloth.positions;
  EXPECT_NEAR((positions.col(middle + 1) - positions.col(middle)).norm(), across_m,
              0.11 * across_m);
}

TEST(Deformation, stiffer_springs_divide_the_step_into_more_parts) {
  Band band;
  const int few = band.deformation(1).substeps();
  band.scene.springs.stretch *= 100;
  EXPECT_GT(band.deformation(1).substeps(), 3 * few);
}

}  // namespace ribbon::deformation_test
