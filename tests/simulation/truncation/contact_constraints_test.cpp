#include "simulation/truncation/contact_constraints.h"

#include <gtest/gtest.h>

#include "simulation/published/planted_penetrations.h"

namespace ribbon::contact_constraints_test {

using Eigen::Matrix3Xd;

constexpr RibbonGrid grid{5, 3};
constexpr RestSize size{grid, 4, 2};
const PairDistances distances{size, {.min_separation_m = 0.05, .activation_m = 0.2}};
constexpr BroadPhaseLengths lengths{.reach_m = 0.2, .slack_m = 0.1, .longest_displacement_m = 4};

// The flat ribbon over a floor at height floor_y, about to sink by `sink` everywhere.
struct Sinking {
  Sinking(double floor_y, double sink) : planted(ribbon_over_floor(grid, floor_y)) {
    free_positions = planted.positions;
    cloth = {free_positions, Matrix3Xd::Zero(3, grid.particle_count()), 1};
    cloth.positions.row(1).array() -= sink;
    candidates = find_contact_candidates(planted.bodies, lengths, free_positions, cloth.positions);
    constraints =
        contact_constraints(candidates, planted.bodies, distances, 0.3, free_positions, cloth);
  }
  bool keep_apart_once() {
    return keep_apart(constraints, planted.bodies, activity, cloth.positions);
  }

  OverFloor planted;
  Matrix3Xd free_positions;
  Cloth cloth;
  ContactCandidates candidates;
  std::vector<ContactConstraint> constraints;
  RowActivity activity{grid.along, 1};
};

TEST(ContactConstraints, keep_a_sinking_sheet_where_contact_begins) {
  Sinking sheet(-0.5, 1);
  ASSERT_FALSE(sheet.constraints.empty());
  for (int sweep = 0; sweep < 20 && sheet.keep_apart_once();) ++sweep;
  for (int p = 0; p < grid.particle_count(); ++p)
    EXPECT_NEAR(sheet.cloth.positions(1, p), -0.3, 1e-3) << p;
}

TEST(ContactConstraints, do_not_press_what_touches_any_closer_nor_push_it_away) {
  Sinking sheet(-0.1, 0.5);
  for (int sweep = 0; sweep < 20 && sheet.keep_apart_once();) ++sweep;
  for (int p = 0; p < grid.particle_count(); ++p)
    EXPECT_NEAR(sheet.cloth.positions(1, p), 0, 1e-3) << p;
}

TEST(ContactConstraints, are_none_where_nothing_comes_near) {
  EXPECT_TRUE(Sinking(-2, 0.5).constraints.empty());
}

// By hand: a particle 0.1 m over the middle of a triangle of three particles wants 0.2 m. Weights 1
// and -1/3 each: the particle makes up for 1 / (1 + 3/9) of the violation, its opponents for the
// rest.
TEST(ContactConstraints, part_by_momentum_conservation) {
  Matrix3Xd x(3, 4);
  x << 0, -1, 1, 0, 0.1, 0, 0, 0, 0, -1, -1, 2;
  ContactConstraint constraint;
  constraint.vertices = {0, 1, 2, 3};
  constraint.weights << 1, -1.0 / 3, -1.0 / 3, -1.0 / 3;
  constraint.normal << 0, 1, 0;
  constraint.distance_m = 0.2;
  constraint.corrections = constraint.weights / constraint.weights.squaredNorm();
  const Matrix3Xd before = x;
  const Bodies four{{2, 2}, std::nullopt};
  RowActivity activity(2, 1);
  activity.begin(0);
  activity.begin(0);
  EXPECT_TRUE(keep_apart(std::span(&constraint, 1), four, activity, x));
  activity.begin(0);
  EXPECT_FALSE(activity.is_resting(0));
  EXPECT_NEAR(x(1, 0) - before(1, 0), 0.1 * 3 / 4, 1e-15);
  EXPECT_NEAR(x(1, 1) - before(1, 1), -0.1 / 4, 1e-15);
  EXPECT_NEAR((x - before).rowwise().sum().norm(), 0, 1e-15);
  EXPECT_FALSE(keep_apart(std::span(&constraint, 1), four, activity, x));
}

}  // namespace ribbon::contact_constraints_test
