#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "simulation/published/planted_penetrations.h"
#include "simulation/state/edge_strain.h"
#include "simulation/step/gated_step.h"
#include "simulation/truncation/contact_candidates.h"

namespace ribbon::gated_step_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr RibbonGrid grid{21, 5};
constexpr RestSize size{grid, 20,
                        4};  // edges of 1 m: a minimum separation of 0.05, contact from 0.2 m on
constexpr double step_s = 0.1;

Cloth cloth_at(const Matrix3Xd& positions) {
  return {positions, Matrix3Xd::Zero(3, grid.particle_count()), 1};
}

// Springs are not asked: what they would do is done to the cloth by hand.
Scene scene_of_step() {
  Scene scene;
  scene.ribbon.width_m = size.width_m;
  scene.springs = {.stretch = 1, .shear = 1};
  scene.recording.max_position_error = 0;
  scene.time.step_s = step_s;
  return scene;
}

GatedStep step_of(const Scene& scene) {
  return {scene, size, contact_lengths(scene, size), 1};
}

// One step at the cloth's velocities.
void drift(GatedStep& gated, Bodies& bodies, Cloth& cloth) {
  const Matrix3Xd before = cloth.positions;
  cloth.positions += step_s * cloth.velocities;
  gated.correct(before, bodies, cloth);
}

double smallest_height(const Cloth& cloth) {
  return cloth.positions.row(1).minCoeff();
}

TEST(GatedStep, a_sheet_that_falls_comes_to_rest_over_the_floor) {
  OverFloor planted = ribbon_over_floor(grid, -1);
  Cloth cloth = cloth_at(planted.positions);
  GatedStep gated = step_of(scene_of_step());
  for (int step = 0; step < 30; ++step) {
    cloth.velocities.row(1).array() -= 1;
    drift(gated, planted.bodies, cloth);
    ASSERT_GE(smallest_height(cloth), -1 + 0.05) << step;
  }
  EXPECT_LT(smallest_height(cloth), -1 + 0.3);
}

TEST(GatedStep, nothing_passes_however_far_the_target_lies_beyond) {
  OverFloor planted = ribbon_over_floor(grid, -0.3);
  Cloth cloth = cloth_at(planted.positions);
  GatedStep gated = step_of(scene_of_step());
  for (int round = 0; round < 20; ++round) {
    const Matrix3Xd before = cloth.positions;
    cloth.positions.row(1).array() -= 3;
    gated.correct(before, planted.bodies, cloth);
    ASSERT_GE(smallest_height(cloth), -0.3 + 0.05 - 1e-12) << round;
  }
}

// By hand: one step of each at 300 m/s takes it 30 edges on, and the next as far; a floor that it
// meets on the way stops it.
TEST(GatedStep, goes_as_far_in_a_step_as_its_velocity_leads_and_contact_lets) {
  for (const double wind_m_s : {300.0, -300.0}) {
    OverFloor planted = ribbon_over_floor(grid, -40);
    Cloth cloth = cloth_at(planted.positions);
    cloth.velocities.row(1).array() += wind_m_s;
    GatedStep gated = step_of(scene_of_step());
    const Matrix3Xd no_force(3, 0);
    for (int step = 1; step <= 2; ++step) {
      (void)gated.advance_under(no_force, planted.bodies, cloth);
      const bool is_stopped = wind_m_s < 0 && step == 2;
      const double height_m = is_stopped ? -40 : planted.positions(1, 0) + 0.1 * step * wind_m_s;
      EXPECT_NEAR(smallest_height(cloth), height_m, is_stopped ? 0.2 : 1e-9) << step;
      EXPECT_GE(smallest_height(cloth), -40 + 0.05 - 1e-12);
    }
  }
}

TEST(GatedStep, tells_how_many_particles_were_truncated) {
  OverFloor planted = ribbon_over_floor(grid, -0.3);
  Cloth cloth = cloth_at(planted.positions);
  GatedStep gated = step_of(scene_of_step());
  const Matrix3Xd before = cloth.positions;
  EXPECT_EQ(gated.correct(before, planted.bodies, cloth).truncated, 0);
  // Of what does not move no displacement is longer than four edges, however free it is.
  cloth.positions.row(0).array() += 30;
  EXPECT_EQ(gated.correct(before, planted.bodies, cloth).truncated, grid.particle_count());
}

// Its end is pulled as hard as all of it can bear. Sweeps alone would pass that on row by row: 60 a
// step here.
TEST(GatedStep, a_long_end_that_is_pulled_takes_few_sweeps) {
  constexpr RibbonGrid long_grid{400, 3};
  const RestSize long_size{long_grid, 399, 2};
  OverFloor planted = ribbon_over_floor(long_grid, -5);
  Cloth cloth{planted.positions, Matrix3Xd::Zero(3, long_grid.particle_count()), 1};
  const Scene scene = scene_of_step();
  GatedStep gated(scene, long_size, contact_lengths(scene, long_size), 1);
  constexpr int steps = 40;
  for (int step = 0; step < steps; ++step) {
    cloth.velocities.bottomRightCorner(3, long_grid.across).row(0).array() += 40;
    drift(gated, planted.bodies, cloth);
    ASSERT_TRUE(gated.is_bearable(cloth)) << step;
  }
  EXPECT_LT(gated.phase_sums().sweeps, 150 * steps);
}

// Both ends are pulled outward while all of it is pressed on the floor. Rounded by 0.01 m, what is
// recorded differs by up to 3.5 % of an edge more.
TEST(GatedStep, what_is_pulled_against_contact_stays_within_the_strain_limit_as_recorded) {
  for (const double rounding_m : {0.0, 0.01}) {
    OverFloor planted = ribbon_over_floor(grid, -0.3);
    Cloth cloth = cloth_at(planted.positions);
    Scene scene = scene_of_step();
    scene.recording.max_position_error = rounding_m / size.length_m;
    GatedStep gated = step_of(scene);
    const double begun_m = cloth.positions.row(0).maxCoeff();
    for (int step = 0; step < 50; ++step) {
      for (int p = 0; p < grid.particle_count(); ++p) {
        cloth.velocities(0, p) += grid.row(p) > 15 ? 1 : grid.row(p) < 5 ? -1 : 0;
        cloth.velocities(1, p) -= 0.5;
      }
      drift(gated, planted.bodies, cloth);
      ASSERT_LE(worst_strain(spring_network(size, {.stretch = 1, .shear = 1}), cloth.positions) +
                    2 * std::sqrt(3) * rounding_m,
                0.1)
          << step;
      ASSERT_GE(smallest_height(cloth),
                -0.3 + (1 - 1e-12) * contact_lengths(scene, size).min_separation_m)
          << step;
    }
    EXPECT_GT(cloth.positions.row(0).maxCoeff(), begun_m + 0.5);
  }
}

// By hand: each step adds 1 m/s down, which contact takes away again, plus a tenth: friction takes
// about 0.3 m/s of the 5 m/s along the floor in each step, none takes nothing.
TEST(GatedStep, friction_slows_what_slides_under_pressure) {
  for (const double friction : {0.0, 0.3}) {
    OverFloor planted = ribbon_over_floor(grid, -0.15);
    Cloth cloth = cloth_at(planted.positions);
    cloth.velocities.row(0).setConstant(5);
    Scene scene = scene_of_step();
    scene.friction = friction;
    GatedStep gated = step_of(scene);
    for (int step = 0; step < 8; ++step) {
      cloth.velocities.row(1).array() -= 1;
      drift(gated, planted.bodies, cloth);
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
  const BroadPhaseLengths lengths{.reach_m = 1, .slack_m = 0, .longest_way_m = 0};
  const ContactCandidates near = BroadPhase(lengths).detect(bodies, x, x, x);
  double smallest = 1;
  for (std::size_t i = 0; i < near.pairs.size(); ++i) {
    const auto& v = near.pairs[i].vertices;
    if (std::abs(grid.row(v.front()) - grid.row(v.back())) >= 5)
      smallest = std::min(smallest, near.distances_m[i]);
  }
  return smallest;
}

TEST(GatedStep, thick_layers_part_to_their_thickness_and_are_not_pressed_under_half_of_it) {
  const Matrix3Xd start = folded_ribbon(grid, 0.4);
  Bodies bodies = ribbon_alone(grid);
  Cloth cloth = cloth_at(start);
  Scene scene = scene_of_step();
  scene.ribbon.thickness_m = 0.6;
  GatedStep gated = step_of(scene);
  EXPECT_NEAR(gap_between_layers(bodies, cloth.positions), 0.4, 0.01);
  for (int step = 0; step < 10; ++step) drift(gated, bodies, cloth);
  EXPECT_NEAR(gap_between_layers(bodies, cloth.positions), 0.6, 0.05);
  double closest = 1;
  for (int step = 0; step < 20; ++step) {
    for (int p = 0; p < grid.particle_count(); ++p)
      cloth.velocities(1, p) += grid.row(p) < 10 ? 3 : -3;
    drift(gated, bodies, cloth);
    closest = std::min(closest, gap_between_layers(bodies, cloth.positions));
  }
  EXPECT_GE(closest, 0.3 - 1e-9);
  EXPECT_LT(closest, 0.595);
}

TEST(GatedStep, flat_neighbours_are_at_rest_however_thick_the_cloth) {
  const Matrix3Xd flat = flat_ribbon(grid);
  Bodies bodies = ribbon_alone(grid);
  Cloth cloth = cloth_at(flat);
  Scene scene = scene_of_step();
  scene.ribbon.thickness_m = 3;
  GatedStep gated = step_of(scene);
  drift(gated, bodies, cloth);
  EXPECT_EQ(cloth.positions, flat);
}

}  // namespace ribbon::gated_step_test
