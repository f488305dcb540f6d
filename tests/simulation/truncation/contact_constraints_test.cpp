#include "simulation/truncation/contact_constraints.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "simulation/detection/closest_weights.h"
#include "simulation/published/planted_penetrations.h"

namespace ribbon::contact_constraints_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr RibbonGrid grid{5, 3};
constexpr RestSize size{grid, 4, 2};
const PairDistances distances{size, {.min_separation_m = 0.05, .activation_m = 0.2}};
constexpr BroadPhaseLengths lengths{.reach_m = 0.2, .slack_m = 0.1, .longest_way_m = 4};

// A vertex and a triangle.
ContactCandidates only(const std::array<int, 4>& vertices, const Matrix3Xd& positions,
                       const Bodies& bodies, double distance_m = 0.1) {
  const FeaturePair pair{FeaturePair::Kind::vertex_triangle, vertices};
  return {.from = positions,
          .bounds = {},
          .pairs = {pair},
          .distances_m = {distance_m},
          .weights = {closest_weights(pair.kind, corners(pair, bodies.vertices(positions)))}};
}

// The flat ribbon over a floor at height floor_y, about to sink by `sink` everywhere.
struct Sinking {
  Sinking(double floor_y, double sink) : planted(ribbon_over_floor(grid, floor_y)) {
    free_positions = planted.positions;
    cloth = {free_positions, Matrix3Xd::Zero(3, grid.particle_count()), 1};
    cloth.positions.row(1).array() -= sink;
    candidates =
        BroadPhase(lengths).detect(planted.bodies, free_positions, free_positions, cloth.positions);
    constraints.find(candidates, planted.bodies, distances, 0.1, free_positions, cloth.positions);
    constraints.begin_sweeps();
  }
  bool keep_apart_once() {
    return constraints.keep_apart(friction, free_positions, planted.bodies, activity, cloth);
  }

  OverFloor planted;
  Matrix3Xd free_positions;
  Cloth cloth;
  ContactCandidates candidates;
  ContactConstraints constraints;
  SweepActivity activity{grid, 1};
  double friction = 0;
};

TEST(ContactConstraints, keep_a_sinking_sheet_where_contact_begins) {
  Sinking sheet(-0.5, 1);
  ASSERT_FALSE(sheet.constraints.found().empty());
  for (int sweep = 0; sweep < 20 && sheet.keep_apart_once();) ++sweep;
  for (int p = 0; p < grid.particle_count(); ++p)
    EXPECT_NEAR(sheet.cloth.positions(1, p), -0.3, 1e-3) << p;
}

// By hand: of the 0.1 m that lack to where contact begins, a fifth is made up for.
TEST(ContactConstraints, move_what_is_pressed_together_apart_gently) {
  Sinking sheet(-0.1, 0.5);
  for (int sweep = 0; sweep < 20 && sheet.keep_apart_once();) ++sweep;
  for (int p = 0; p < grid.particle_count(); ++p)
    EXPECT_NEAR(sheet.cloth.positions(1, p), 0.02, 1e-3) << p;
}

// By hand, of a vertex that weighs three times as much as each corner of the triangle beneath, over
// its middle: of the way apart it makes one part, and they three. lightness: 1/3 and 1.
TEST(ContactConstraints, move_what_is_light_farther) {
  const Bodies bodies{grid, std::nullopt};
  Matrix3Xd positions = flat_ribbon(grid);
  const int vertex = grid.particle(4, 1);
  positions.col(vertex) = (positions.col(0) + positions.col(3) + positions.col(1)) / 3;
  positions(1, vertex) = 0.1;
  Eigen::ArrayXd lightness = Eigen::ArrayXd::Ones(grid.particle_count());
  lightness[vertex] = 1.0 / 3;
  ContactConstraints constraints(lightness);
  constraints.find(only({vertex, 0, 3, 1}, positions, bodies), bodies, distances, 0.1, positions,
                   positions);
  ASSERT_EQ(constraints.found().size(), 1U);
  EXPECT_NEAR(constraints.found()[0].corrections[0], 0.5, 1e-12);
  EXPECT_NEAR(constraints.found()[0].corrections[1], -0.5, 1e-12);
}

TEST(ContactConstraints, stop_what_sinks_without_throwing_it_back) {
  Sinking sheet(-0.5, 1);
  sheet.cloth.velocities.row(0).setConstant(3);
  sheet.cloth.velocities.row(1).setConstant(-2);
  for (int sweep = 0; sweep < 20 && sheet.keep_apart_once();) ++sweep;
  EXPECT_NEAR(sheet.cloth.velocities.row(1).cwiseAbs().maxCoeff(), 0, 1e-9);
  EXPECT_NEAR((sheet.cloth.velocities.row(0).array() - 3).abs().maxCoeff(), 0, 1e-9);
}

// By hand: 0.7 m of the sinking are undone; Coulomb's law then undoes 0.35 m of sliding, or all of
// what is less.
TEST(ContactConstraints, with_friction_hold_what_slides) {
  for (const double slid : {0.9, 0.2}) {
    Sinking sheet(-0.5, 1);
    sheet.friction = 0.5;
    sheet.cloth.positions.row(2).array() += slid;
    for (int sweep = 0; sweep < 20 && sheet.keep_apart_once();) ++sweep;
    for (int p = 0; p < grid.particle_count(); ++p)
      EXPECT_NEAR(sheet.cloth.positions(2, p) - sheet.free_positions(2, p),
                  std::max(0.0, slid - 0.35), 0.02)
          << p;
  }
}

// Over a floor of many triangles: each particle goes aside over several of their edges and sinks
// through it. Whichever it comes down on holds it.
TEST(ContactConstraints, keep_what_slides_over_a_mesh_from_sinking_into_it) {
  constexpr RibbonGrid floor_grid{41, 41};
  Matrix3Xd floor = 0.4 * flat_ribbon(floor_grid);
  floor.colwise() -= Vector3d(3.1, 0, 4.3);
  Bodies bodies{grid, ObstacleBody(floor_grid.triangles(), floor)};
  std::mt19937 random(8);
  std::uniform_real_distribution<double> part(0, 1);
  const auto between = [&](double least, double most) {
    return least + (most - least) * part(random);
  };
  for (int trial = 0; trial < 50; ++trial) {
    Matrix3Xd before = flat_ribbon(grid);
    before.row(1).setConstant(between(0.06, 0.2));
    Cloth cloth{before, Matrix3Xd::Zero(3, grid.particle_count()), 1};
    cloth.positions.row(0).array() += between(-2, 2);
    cloth.positions.row(1).array() -= between(0.1, 1);
    cloth.positions.row(2).array() += between(-2, 2);
    ContactConstraints constraints;
    constraints.find(BroadPhase(lengths).detect(bodies, before, before, cloth.positions), bodies,
                     distances, 0.1, before, cloth.positions);
    constraints.begin_sweeps();
    SweepActivity activity(grid, 1);
    for (int sweep = 0; sweep < 40 && constraints.keep_apart(0, before, bodies, activity, cloth);)
      ++sweep;
    EXPECT_GT(cloth.positions.row(1).minCoeff(), 0.05) << trial;
  }
}

// A vertex over the triangle 0, 3, 1 and what it is about to do.
struct Flying {
  explicit Flying(const Vector3d& from, const Vector3d& way) {
    cloth.positions.col(vertex) = from;
    before = cloth.positions;
    cloth.positions.col(vertex) += way;
    cloth.velocities.col(vertex) = 100 * way;
    constraints.find(only({vertex, 0, 3, 1}, before, bodies), bodies, distances, 0.1, before,
                     cloth.positions);
  }
  void keep_apart_once() {
    SweepActivity activity(grid, 1);
    constraints.begin_sweeps();
    constraints.keep_apart(0, before, bodies, activity, cloth);
  }
  [[nodiscard]] Vector3d normal() const { return constraints.found().at(0).normal; }

  int vertex = grid.particle(4, 1);
  Bodies bodies{grid, std::nullopt};
  Cloth cloth{flat_ribbon(grid), Matrix3Xd::Zero(3, grid.particle_count()), 1};
  Matrix3Xd before;
  ContactConstraints constraints;
};

// It comes from beside the triangle, at a height at which contact has begun.
TEST(ContactConstraints, do_not_hold_up_what_slides_past) {
  Flying past({-0.3, 0.15, 0.2}, {0.9, 0, 0});
  past.keep_apart_once();
  EXPECT_NEAR(past.cloth.velocities(0, past.vertex), 90, 1e-9);
  EXPECT_NEAR(past.cloth.positions(0, past.vertex), 0.6, 1e-12);
  EXPECT_GT(past.cloth.positions(1, past.vertex), 0.15);  // contact opens
}

TEST(ContactConstraints, keep_what_hardly_moves_from_where_it_is_closest) {
  EXPECT_TRUE(
      Flying({-0.15, 0.15, 0.2}, {0.01, 0, 0}).normal().isApprox(Vector3d(-1, 1, 0).normalized()));
  EXPECT_TRUE(Flying({-0.15, 0.15, 0.2}, {0.5, 0, 0}).normal().isApprox(Vector3d(0, 1, 0)));
}

TEST(ContactConstraints, hold_what_would_fly_through) {
  Flying through({0.1, 0.15, 0.2}, {0.1, -0.5, 0.1});
  EXPECT_TRUE(through.normal().isApprox(Vector3d(0, 1, 0)));
  through.keep_apart_once();
  EXPECT_GE(through.cloth.velocities(1, through.vertex), -30);
}

// It flies level beside the obstacle's triangle, too high to touch it, were it not for its weight.
// That turns no normal: beside where it falls to, the triangle lies level.
TEST(ContactConstraints, count_where_weight_alone_leads_to_contact) {
  const int vertex = grid.particle(4, 1);
  const int corner = grid.particle_count();
  Matrix3Xd before = flat_ribbon(grid);
  const Bodies bodies{grid, ObstacleBody(Eigen::Vector3i(0, 2, 1), before(Eigen::all, {0, 1, 3}))};
  before.col(vertex) = Vector3d(-0.3, 0.4, 0.2);
  Matrix3Xd target = before;
  target.col(vertex).x() += 0.05;
  const Vector3d fall_m(0, -0.6, 0);
  ContactConstraints constraints;
  const ContactCandidates candidates =
      only({vertex, corner, corner + 2, corner + 1}, before, bodies, 0.4);
  constraints.find(candidates, bodies, distances, 0.1, before, target);
  EXPECT_TRUE(constraints.found().empty());
  constraints.find(candidates, bodies, distances, 0.1, before, target, fall_m);
  ASSERT_EQ(constraints.found().size(), 1U);
  EXPECT_TRUE(constraints.found()[0].normal.isApprox(Vector3d(-0.6, 0.8, 0)));
}

TEST(ContactConstraints, are_none_where_nothing_comes_near) {
  EXPECT_TRUE(Sinking(-2, 0.5).constraints.found().empty());
}

// By hand: a particle 0.1 m over the middle of a triangle of three particles wants 0.2 m. Weights 1
// and -1/3 each: the particle makes up for 1 / (1 + 3/9) of the violation, its opponents for the
// rest.
TEST(ContactConstraints, part_by_momentum_conservation) {
  constexpr RestSize of_four{{2, 2}, 4, 2};
  const Bodies bodies{of_four.grid, std::nullopt};
  Cloth cloth{Matrix3Xd(3, 4), Matrix3Xd::Zero(3, 4), 1};
  Matrix3Xd& x = cloth.positions;
  x << 0, -1, 1, 0, 0.1, 0, 0, 0, 0, -1, -1, 2;
  const Matrix3Xd before = x;
  const PairDistances clear{of_four, {.min_separation_m = 0.2 / 1.2, .activation_m = 0.2}};
  ContactConstraints constraints;
  constraints.find(only({0, 1, 2, 3}, x, bodies), bodies, clear, 0.3, x, x);
  SweepActivity activity(of_four.grid, 1);
  constraints.begin_sweeps();
  EXPECT_TRUE(constraints.keep_apart(0, before, bodies, activity, cloth));
  activity.begin(contact_task);
  EXPECT_FALSE(activity.is_resting(0));
  EXPECT_NEAR(x(1, 0) - before(1, 0), 0.1 * 3 / 4, 1e-15);
  EXPECT_NEAR(x(1, 1) - before(1, 1), -0.1 / 4, 1e-15);
  EXPECT_NEAR((x - before).rowwise().sum().norm(), 0, 1e-15);
  EXPECT_FALSE(constraints.keep_apart(0, before, bodies, activity, cloth));
}

// Pairs are passed over because they would stay as they are.
TEST(ContactConstraints, sweep_to_the_same_bits_whether_they_look_at_pairs_that_keep_apart_or_not) {
  Sinking sheet(-0.5, 0.25);
  Sinking looked_at = sheet;
  std::mt19937 random(3);
  std::uniform_int_distribution<int> particle(0, grid.particle_count() - 1);
  std::uniform_real_distribution<double> sink(0, 0.2);
  for (int sweep = 0; sweep < 40; ++sweep) {
    const int sinking = particle(random);
    const double by_m = sink(random);
    for (Sinking* one : {&sheet, &looked_at}) {
      one->cloth.positions(1, sinking) -= by_m;
      one->activity.move(sinking, by_m);
    }
    looked_at.constraints.begin_sweeps();
    ASSERT_EQ(sheet.keep_apart_once(), looked_at.keep_apart_once());
    ASSERT_EQ(sheet.cloth.positions, looked_at.cloth.positions) << sweep;
  }
  EXPECT_LT(sheet.cloth.positions.row(1).minCoeff(), -0.28);
}

}  // namespace ribbon::contact_constraints_test
