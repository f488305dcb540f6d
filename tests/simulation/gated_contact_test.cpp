#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "simulation/contact.h"
#include "simulation/planted_penetrations.h"
#include "simulation/surroundings.h"

namespace ribbon {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr RibbonGrid grid{21, 5};
constexpr NaturalSize size{grid, 20, 4};  // edges of 1 m: a hard gap of 0.05, contact from 0.2 m on
constexpr double step_s = 0.1;

Cloth cloth_at(const Matrix3Xd& positions) {
  return {positions, Matrix3Xd::Zero(3, grid.particle_count()), 1};
}

// One step at the cloth's velocities.
void drift(Contact& contact, Cloth& cloth) {
  const Matrix3Xd before = cloth.positions;
  cloth.positions.leftCols(grid.particle_count()) += step_s * cloth.velocities;
  contact.after_displacement(before, cloth);
}

double smallest_height(const Cloth& cloth) {
  return cloth.positions.row(1).leftCols(grid.particle_count()).minCoeff();
}

TEST(GatedContact, a_sheet_that_falls_comes_to_rest_over_the_floor) {
  OverFloor planted = ribbon_over_floor(grid, -1);
  Cloth cloth = cloth_at(planted.positions);
  const auto contact = gated_contact(planted.bodies, {.size = size}, step_s);
  for (int step = 0; step < 30; ++step) {
    cloth.velocities.row(1).array() -= 1;
    drift(*contact, cloth);
    ASSERT_GE(smallest_height(cloth), -1 + 0.05) << step;
  }
  EXPECT_LT(smallest_height(cloth), -1 + 0.3);
}

TEST(GatedContact, nothing_passes_between_smoothing_and_the_next_step_either) {
  OverFloor planted = ribbon_over_floor(grid, -0.3);
  Cloth cloth = cloth_at(planted.positions);
  const auto contact = gated_contact(planted.bodies, {.size = size}, step_s);
  drift(*contact, cloth);
  for (int round = 0; round < 20; ++round) {
    // A smoothing that wants everything under the floor.
    cloth.positions.row(1).leftCols(grid.particle_count()).array() -= 3;
    contact->after_smoothing(cloth);
    ASSERT_GE(smallest_height(cloth), -0.3 + 0.05 - 1e-12) << round;
  }
}

// By hand: each step adds 1 m/s down, which contact takes away again, plus a tenth: friction takes
// about 0.3 m/s of the 5 m/s along the floor in each step, none takes nothing.
TEST(GatedContact, friction_slows_what_slides_under_pressure) {
  for (const double friction : {0.0, 0.3}) {
    OverFloor planted = ribbon_over_floor(grid, -0.15);
    Cloth cloth = cloth_at(planted.positions);
    cloth.velocities.row(0).setConstant(5);
    const auto contact =
        gated_contact(planted.bodies, {.size = size, .friction = friction}, step_s);
    for (int step = 0; step < 8; ++step) {
      cloth.velocities.row(1).array() -= 1;
      drift(*contact, cloth);
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

TEST(GatedContact, thick_layers_part_to_their_thickness_and_are_not_pressed_under_half_of_it) {
  const Matrix3Xd start = folded_ribbon(grid, 0.4);
  Bodies bodies = ribbon_alone(grid, start);
  Cloth cloth = cloth_at(start);
  const auto contact = gated_contact(bodies, {.size = size, .thickness_m = 0.6}, step_s);
  EXPECT_NEAR(gap_between_layers(bodies, cloth.positions), 0.4, 0.01);
  for (int step = 0; step < 10; ++step) drift(*contact, cloth);
  EXPECT_NEAR(gap_between_layers(bodies, cloth.positions), 0.6, 0.05);
  double closest = 1;
  for (int step = 0; step < 20; ++step) {
    for (int p = 0; p < grid.particle_count(); ++p)
      cloth.velocities(1, p) += grid.row(p) < 10 ? 4 : -4;
    drift(*contact, cloth);
    closest = std::min(closest, gap_between_layers(bodies, cloth.positions));
  }
  EXPECT_GE(closest, 0.3 - 1e-9);
  EXPECT_LT(closest, 0.5);
}

TEST(GatedContact, flat_neighbours_are_at_rest_however_thick_the_cloth) {
  const Matrix3Xd flat = flat_ribbon(grid);
  Bodies bodies = ribbon_alone(grid, flat);
  Cloth cloth = cloth_at(flat);
  const auto contact = gated_contact(bodies, {.size = size, .thickness_m = 3}, step_s);
  drift(*contact, cloth);
  EXPECT_EQ(cloth.positions, flat);
}

}  // namespace
}  // namespace ribbon
