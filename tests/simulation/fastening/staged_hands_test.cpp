#include "simulation/fastening/staged_hands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geometry/flat_ribbon.h"
#include "ribbon_mesh/springs.h"
#include "simulation/integration/integrator.h"

namespace ribbon::staged_hands_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr RestSize size{{101, 2}, 100, 1};

HandScene hand(double begin, double end, HandTask task, const Vector3d& direction = {0, 0, 0}) {
  return {.at = Span{begin, end}, .task = task, .direction = direction, .speed_m_s = 3};
}

Scene scene_of(std::vector<StageScene> stages) {
  Scene scene;
  scene.air_resistance_per_s = 2;
  scene.friction = 0.25;
  scene.fastening = FasteningScene{.speed_m_s = 3};
  scene.fastening->axis_point_m = {50, 0, 7};
  scene.time = {.step_s = 0.1, .duration_s = 100};
  scene.stages = std::move(stages);
  return scene;
}

Cloth cloth_at_rest(double stretch = 1) {
  Cloth cloth{flat_ribbon(size.grid), Matrix3Xd::Zero(3, size.grid.particle_count()), 0.5};
  cloth.positions.row(0) *= stretch;
  return cloth;
}

StagedHands hands_of(const Scene& scene) {
  return {scene, size, cloth_at_rest()};
}

Matrix3Xd rows(const Matrix3Xd& of_particles, int first, int count) {
  return of_particles.middleCols(size.grid.particle(first, 0), count * size.grid.across);
}

TEST(StagedHands, pull_the_rows_that_they_have_and_no_others) {
  const Vector3d up{0, 0.6, 0.8};
  StagedHands hands = hands_of(scene_of({{.hands = {hand(0.1, 0.19, HandTask::pull, up)}}}));
  const Matrix3Xd force = hands.pull(cloth_at_rest());
  // By hand: ten rows draw half of 101, whose particles have 0.5 kg, at 3 m/s against the air.
  const Vector3d each = 0.5 * 2 * 3 * (0.5 * 101 / 10) * up;
  EXPECT_TRUE(rows(force, 10, 10).isApprox(each.replicate(1, 20)));
  EXPECT_EQ(rows(force, 0, 10).norm(), 0);
  EXPECT_EQ(rows(force, 20, 81).norm(), 0);
}

TEST(StagedHands, along_on_all_of_the_band_is_the_fastening_force) {
  const Scene scene = scene_of({{.hands = {hand(0, 1, HandTask::pull_along)}}});
  const Cloth cloth = cloth_at_rest();
  FasteningForce published(*scene.fastening, 2, size, cloth.positions, 0.5);
  EXPECT_TRUE(hands_of(scene).pull(cloth).isApprox(published.at(cloth.positions)));
}

TEST(StagedHands, outwards_is_straight_away_from_the_axis) {
  Scene scene = scene_of({{.hands = {hand(0.5, 0.5, HandTask::pull_outwards)}}});
  const Cloth cloth = cloth_at_rest();
  const Vector3d force = hands_of(scene).pull(cloth).col(size.grid.particle(50, 0));
  EXPECT_TRUE(force.normalized().isApprox(Vector3d(0, 0, -1)));
  // A part that lies on the axis is not pulled anywhere.
  scene.fastening->axis_point_m = {50, 0, cloth.positions(2, size.grid.particle(50, 0)) + 0.5};
  EXPECT_TRUE(hands_of(scene).pull(cloth).allFinite());
}

TEST(StagedHands, yield_to_the_strain_near_them_alone) {
  Scene scene = scene_of({{.hands = {hand(0, 0.05, HandTask::pull, {1, 0, 0}),
                                     hand(0.9, 1, HandTask::pull, {1, 0, 0})}}});
  for (HandScene& one : scene.stages[0].hands) one.yield_strain = 0.05;
  StagedHands hands = hands_of(scene);
  Cloth cloth = cloth_at_rest();
  const Matrix3Xd all = hands.pull(cloth);
  EXPECT_EQ(hands.force_fraction(), 1);
  cloth.positions.row(0).rightCols(8 * size.grid.across) *= 1.5;  // beside the second
  const Matrix3Xd felt = hands.pull(cloth);
  EXPECT_TRUE(rows(felt, 0, 6).isApprox(rows(all, 0, 6)));
  EXPECT_EQ(rows(felt, 90, 11).norm(), 0);
  EXPECT_EQ(hands.force_fraction(), 0.5);
}

TEST(StagedHands, hold_each_particle_where_it_was_when_the_stage_began) {
  Scene scene = scene_of({{.until_s = 9, .hands = {hand(0.1, 0.19, HandTask::hold)}}});
  scene.fastening->max_speed_m_s = 4;
  StagedHands hands = hands_of(scene);
  Cloth cloth = cloth_at_rest();
  cloth.positions.array() += 0.25;
  EXPECT_EQ(hands.pull(cloth).norm(), 0) << "it holds by a grip alone";
  ASSERT_EQ(hands.grips().size(), 1U);
  const Grip& grip = hands.grips()[0];
  EXPECT_EQ(grip.first, size.grid.particle(10, 0));
  EXPECT_THAT(grip.weights, testing::ElementsAreArray(std::vector<double>(20, 1.0)));
  EXPECT_EQ(grip.places, rows(cloth_at_rest().positions, 10, 10));
  EXPECT_EQ(grip.most_m_s, 4);
  // By hand: ten rows are as strong as if they drew half of 101 at 3 m/s against the air.
  EXPECT_DOUBLE_EQ(grip.most_m_s2, 2 * 3 * (0.5 * 101 / 10));
  hands.ease();
  (void)hands.pull(cloth);
  EXPECT_DOUBLE_EQ(hands.grips()[0].most_m_s2, 3 * (0.5 * 101 / 10));
}

// In drawing units, which are millimetres: from beside the row in the middle 4 m to the right, 3 m
// up.
HandScene carrying_hand(double begin = 0.5, double end = 0.5) {
  HandScene carrying = hand(begin, end, HandTask::carry);
  carrying.carry = {std::vector<Eigen::Vector2d>{{50'000, 500}, {54'000, 500}}, {{0, 0}, {1, 3}}};
  return carrying;
}

// Particles on which nothing else acts but what has them, with the steps of the simulation.
class Carried {
 public:
  explicit Carried(const Scene& scene)
      : hands_(scene, size, cloth_),
        integrator_(symplectic_euler(spring_network(size, {}),
                                     {.step_s = 0.1,
                                      .particle_mass_kg = 0.5,
                                      .air_resistance_per_s = scene.air_resistance_per_s})) {}

  void step() {
    hands_.begin_step(cloth_);
    const Matrix3Xd& force = hands_.pull(cloth_);
    integrator_->take_grips(hands_.grips());
    integrator_->displace(force, cloth_);
    hands_.follow(cloth_);
  }
  // In which something holds it back in the end. Returns how fast it would have been.
  Matrix3Xd step_stuck() {
    const Cloth before = cloth_;
    step();
    Matrix3Xd velocities = rows(cloth_.velocities, 30, 41);
    cloth_ = before;
    return velocities;
  }
  [[nodiscard]] Vector3d middle() const { return rows(cloth_.positions, 50, 1).rowwise().mean(); }
  [[nodiscard]] const StagedHands& hands() const { return hands_; }
  StagedHands& hands() { return hands_; }
  Cloth& cloth() { return cloth_; }

 private:
  Cloth cloth_ = cloth_at_rest();
  StagedHands hands_;
  std::unique_ptr<Integrator> integrator_;
};

TEST(StagedHands, what_they_carry_follows_the_path_and_stays_at_its_end) {
  Carried row(scene_of({{.until_s = 90, .hands = {carrying_hand()}}}));
  double farthest_off_m = 0;
  for (int step = 0; step < 100; ++step) {
    row.step();
    const Vector3d gone = row.middle() - Vector3d(50, 0, 0.5);
    farthest_off_m = std::max(farthest_off_m, std::abs(gone.y() - 0.75 * gone.x()));
  }
  EXPECT_LT(farthest_off_m, 0.05) << "it climbs 3 on 4";
  EXPECT_TRUE(row.middle().isApprox(Vector3d(54, 3, 0.5), 1e-3)) << row.middle().transpose();
  EXPECT_LT(row.cloth().velocities.norm(), 1e-2);
}

TEST(StagedHands, a_stage_is_over_when_all_is_carried) {
  const auto steps_of = [](double speed_m_s) {
    Scene scene = scene_of({{.hands = {carrying_hand()}, .goal = StageGoal::carried},
                            {.until_s = 9, .hands = {hand(0, 0, HandTask::hold)}}});
    scene.stages[0].hands[0].speed_m_s = speed_m_s;
    Carried row(scene);
    const double way_m = (Vector3d(50, 0, 0.5) - row.middle()).norm() + 5;
    int steps = 0;
    for (; steps < 500 && row.hands().stage() == 0; ++steps) row.step();
    return steps - 1 - way_m / (0.1 * speed_m_s);
  };
  // It begins where the row is; the last part of a step counts as a whole one, and in the next the
  // row comes to rest.
  EXPECT_GE(steps_of(3), 0);
  EXPECT_LT(steps_of(3), 2);
  EXPECT_GE(steps_of(2), 0);
  EXPECT_LT(steps_of(2), 2);
}

// By hand, of a ribbon 1 m wide: within a quarter of it, where a hundredth of a second of its speed
// would be a whole metre.
TEST(StagedHands, what_strong_hands_carry_has_not_arrived_before_it_is_there) {
  Scene scene = scene_of({{.hands = {carrying_hand(0.3, 0.7)}, .goal = StageGoal::carried},
                          {.until_s = 9, .hands = {hand(0, 0, HandTask::hold)}}});
  scene.stages[0].hands[0].speed_m_s = 100;
  Carried row(scene);
  for (int step = 0; step < 500 && row.hands().stage() == 0; ++step) {
    row.hands().begin_step(row.cloth());
    if (row.hands().stage() == 1) break;
    row.step();
  }
  ASSERT_EQ(row.hands().stage(), 1);
  const Vector3d middle = rows(row.cloth().positions, 30, 41).rowwise().mean();
  EXPECT_LT((middle - Vector3d(54, 3, 0.5)).norm(), 0.25);
  EXPECT_LT(rows(row.cloth().velocities, 30, 41).rowwise().mean().norm(), 5);
}

TEST(StagedHands, wait_for_what_cannot_follow_and_pull_no_harder_than_they_can) {
  // Forty-one rows, of which each draws no more than one or two: they need all their force soon.
  Carried stuck(scene_of({{.hands = {carrying_hand(0.3, 0.7)}, .goal = StageGoal::carried}}));
  Matrix3Xd velocities;
  for (int step = 0; step < 200; ++step) velocities = stuck.step_stuck();
  EXPECT_FALSE(stuck.hands().are_over());
  // By hand: after 0.1 s of all their strength, with what the air takes.
  const double most_m_s = 0.1 * (2 * 3 * (0.5 * 101 / 41)) / (1 + 0.1 * 2);
  EXPECT_NEAR(velocities.col(0).norm(), most_m_s, 1e-9 * most_m_s);
  EXPECT_TRUE(velocities.isApprox(velocities.col(0).replicate(1, 82))) << "it is free to turn";
  for (int step = 0; step < 100; ++step) stuck.step();
  EXPECT_TRUE(stuck.hands().are_over());
  EXPECT_FALSE(stuck.hands().are_done()) << "nothing is tight";
}

// Steps in which each particle moves along its pull by so much.
void pull(StagedHands& hands, int steps, double moved_m) {
  Cloth cloth = cloth_at_rest();
  for (int step = 0; step < steps; ++step) {
    hands.begin_step(cloth);
    const Matrix3Xd way = moved_m * hands.pull(cloth).cwiseSign();
    cloth.positions += way;
    hands.follow(cloth);
    cloth.positions -= way;
  }
}

Scene two_stages() {
  return scene_of({{.friction = 0.5, .hands = {hand(0, 0.1, HandTask::pull, {1, 0, 0})}},
                   {.until_s = 1, .hands = {hand(0.5, 0.6, HandTask::pull, {0, 1, 0})}}});
}

TEST(StagedHands, a_stage_that_is_tight_is_followed_by_the_next) {
  StagedHands hands = hands_of(two_stages());
  EXPECT_EQ(hands.friction(), 0.5);
  pull(hands, 20, 0);
  EXPECT_EQ(hands.stage(), 0) << "the frame after its last step is still its own";
  EXPECT_EQ(hands.progress(), 0);
  pull(hands, 1, 0.3);
  EXPECT_EQ(hands.stage(), 1);
  EXPECT_EQ(hands.friction(), 0.25) << "as in the scene";
  EXPECT_GT(hands.progress(), 0.5) << "measured anew";
}

TEST(StagedHands, a_stage_that_moves_on_is_not_over_until_its_time_is) {
  Scene scene = two_stages();
  StagedHands patient = hands_of(scene);
  pull(patient, 40, 0.2);
  EXPECT_EQ(patient.stage(), 0);
  scene.stages[0].at_most_s = 3;
  StagedHands hurried = hands_of(scene);
  pull(hurried, 30, 0.2);
  EXPECT_EQ(hurried.stage(), 0);
  pull(hurried, 1, 0.2);
  EXPECT_EQ(hurried.stage(), 1);
}

TEST(StagedHands, let_go_when_all_stages_are_over) {
  StagedHands hands = hands_of(two_stages());
  pull(hands, 20 + 10, 0);
  EXPECT_TRUE(hands.are_over());
  EXPECT_FALSE(hands.are_done()) << "it was over by its time";
  EXPECT_EQ(hands.pull(cloth_at_rest()).norm(), 0);
  EXPECT_EQ(hands.force_fraction(), 0);
  pull(hands, 10, 0);
  EXPECT_EQ(hands.stage(), 1);
  EXPECT_TRUE(hands.are_over());
}

TEST(StagedHands, are_done_when_the_last_stage_is_tight) {
  StagedHands hands = hands_of(scene_of({{.hands = {hand(0, 0.1, HandTask::pull, {1, 0, 0})}}}));
  pull(hands, 19, 0);
  EXPECT_FALSE(hands.are_done());
  pull(hands, 30, 0);
  EXPECT_TRUE(hands.are_done());
}

TEST(StagedHands, let_go_when_an_end_slips) {
  StagedHands hands = hands_of(two_stages());
  hands.guard().look({2.0, 50.0});
  EXPECT_GT(hands.pull(cloth_at_rest()).norm(), 0);
  hands.guard().look({1.4, 50.0});
  EXPECT_EQ(hands.guard().slipping_end(), 0);
  EXPECT_EQ(hands.pull(cloth_at_rest()).norm(), 0);
  pull(hands, 40, 0);
  EXPECT_EQ(hands.stage(), 0);
}

TEST(StagedHands, carry_no_further_once_an_end_slips) {
  Carried row(scene_of({{.until_s = 90, .hands = {carrying_hand()}}}));
  for (int step = 0; step < 5; ++step) row.step();
  row.hands().guard().look({2.0, 50.0});
  row.hands().guard().look({1.4, 50.0});
  StateArchive then;
  row.hands().visit_state(then);
  for (int step = 0; step < 3; ++step) row.hands().follow(row.cloth());
  StateArchive later;
  row.hands().visit_state(later);
  EXPECT_EQ(later.bytes(), then.bytes());
}

TEST(StagedHands, have_the_ends_that_they_hold_or_carry) {
  const auto ends = [](double begin, double end, HandTask task) {
    return hands_of(scene_of({{.until_s = 1, .hands = {hand(begin, end, task, {1, 0, 0})}}}))
        .have_ends();
  };
  EXPECT_EQ(ends(0, 0.1, HandTask::hold), (std::array{true, false}));
  EXPECT_EQ(ends(0.9, 1, HandTask::hold), (std::array{false, true}));
  EXPECT_EQ(ends(0.1, 0.9, HandTask::hold), (std::array{false, false}));
  StagedHands carrying = hands_of(scene_of({{.until_s = 1, .hands = {carrying_hand(0.9, 1)}}}));
  EXPECT_EQ(carrying.have_ends(), (std::array{false, true}));
  EXPECT_EQ(ends(0, 0.1, HandTask::pull), (std::array{false, false})) << "its end is loose";
}

// As a take knows them, which forgets how far all went lately.
TEST(StagedHands, that_are_done_stay_so_unless_they_begin_anew) {
  const Scene scene = scene_of({{.hands = {hand(0, 0.1, HandTask::pull, {1, 0, 0})}}});
  StagedHands before = hands_of(scene);
  pull(before, 20, 0);
  ASSERT_TRUE(before.are_done());
  StateArchive archive;
  before.visit_state(archive);
  const std::string state = archive.bytes();
  StagedHands hands = hands_of(scene);
  StateArchive reading(state);
  hands.visit_state(reading);
  ASSERT_TRUE(reading.finish());
  EXPECT_TRUE(hands.are_done());
  EXPECT_EQ(hands.pull(cloth_at_rest()).norm(), 0);
  hands.begin_anew(cloth_at_rest());
  EXPECT_GT(hands.pull(cloth_at_rest()).norm(), 0);
  pull(hands, 19, 0);
  hands.begin_anew(cloth_at_rest());  // it has begun, and goes on
  EXPECT_FALSE(hands.are_over());
  pull(hands, 1, 0);
  EXPECT_TRUE(hands.are_done());
}

TEST(StagedHands, that_gave_up_say_so_also_later) {
  Scene scene = two_stages();
  scene.stages[0].at_most_s = 3;
  StagedHands before = hands_of(scene);
  pull(before, 29, 0.2);
  EXPECT_EQ(before.given_up(), (std::vector{false, false}));
  StateArchive archive;
  before.visit_state(archive);
  const std::string state = archive.bytes();
  for (const double at_most_s : {3.0, 1.0}) {  // a take has less patience
    scene.stages[0].at_most_s = at_most_s;
    StagedHands hands = hands_of(scene);
    StateArchive reading(state);
    hands.visit_state(reading);
    ASSERT_TRUE(reading.finish());
    pull(hands, 2, 0.2);
    EXPECT_EQ(hands.stage(), 1);
    pull(hands, 20, 0);
    EXPECT_EQ(hands.given_up(), (std::vector{true, false})) << "the second lasted as it should";
  }
}

// What a take changes.
TEST(StagedHands, go_on_from_others_that_carried_more_or_fewer_parts) {
  const HandScene first = carrying_hand(0.2, 0.2);
  const HandScene second = carrying_hand(0.8, 0.8);
  const auto scene_with = [](std::vector<HandScene> hands) {
    return scene_of({{.until_s = 90, .hands = std::move(hands)}});
  };
  const auto state_of = [](StagedHands& hands) {
    StateArchive archive;
    hands.visit_state(archive);
    return archive.bytes();
  };
  // How far each place has gone tells what the hand does next.
  const auto places = [&](const Scene& scene, const std::string& state) {
    StagedHands hands = hands_of(scene);
    StateArchive archive(state);
    hands.visit_state(archive);
    const auto read = archive.finish();
    EXPECT_TRUE(read) << read.error().sentence();
    (void)hands.pull(cloth_at_rest());
    std::vector<Vector3d> result;
    for (const Grip& grip : hands.grips()) result.emplace_back(grip.places.col(0));
    return result;
  };
  Carried one(scene_with({first}));
  Carried two(scene_with({first, second}));
  for (int step = 0; step < 5; ++step) {
    one.step();
    two.step();
  }
  const auto of_one = places(scene_with({first}), state_of(one.hands()));
  const auto of_two = places(scene_with({first, second}), state_of(two.hands()));
  EXPECT_NE(of_one[0], of_two[1]);

  const auto fewer = places(scene_with({first}), state_of(two.hands()));
  EXPECT_EQ(fewer[0], of_two[0]);
  const auto last = places(scene_with({second}), state_of(two.hands()));
  EXPECT_EQ(last[0], of_two[1]) << "the other hand is gone";
  const auto swapped = places(scene_with({second, first}), state_of(two.hands()));
  EXPECT_EQ(swapped[0], of_two[1]);
  const auto more = places(scene_with({first, second}), state_of(one.hands()));
  EXPECT_EQ(more[0], of_one[0]);
  StagedHands beginning = hands_of(scene_with({second}));
  EXPECT_EQ(more[1], places(scene_with({second}), state_of(beginning))[0]) << "it begins";
}

// By hand, of a ribbon 2 m wide: 3 m are too short.
TEST(SlipGuard, sees_an_end_that_is_drawn_in_and_not_one_that_comes_to_lie_on_the_knot) {
  SlipGuard slips(2);
  for (const double loose_m : {20.0, 8.0, 5.0, 3.1}) slips.look({50.0, loose_m});
  EXPECT_FALSE(slips.slipping_end().has_value());
  slips.look({50.0, 2.9});
  EXPECT_EQ(slips.slipping_end(), 1);

  SlipGuard lies(2);
  for (const double loose_m : {20.0, 1.0, 0.5, 20.0}) lies.look({loose_m, 50.0});
  EXPECT_FALSE(lies.slipping_end().has_value());

  SlipGuard untied(2);
  untied.look({std::nullopt, std::nullopt});
  untied.look({1.0, std::nullopt});
  EXPECT_FALSE(untied.slipping_end().has_value());
}

}  // namespace ribbon::staged_hands_test
