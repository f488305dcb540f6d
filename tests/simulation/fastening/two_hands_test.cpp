#include "simulation/fastening/two_hands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/published/planted_penetrations.h"

namespace ribbon::two_hands_test {

using Eigen::Matrix3Xd;

constexpr RestSize size{{101, 2}, 100, 1};

Scene scene_of_hands() {
  Scene scene;
  scene.air_resistance_per_s = 2;
  scene.fastening = FasteningScene{.speed_m_s = 3, .yield_strain = unyielding};
  scene.fastening->axis_point_m = {50, 0, 7};  // beside the middle, so that nothing lies on it
  scene.time = {.step_s = 0.1, .duration_s = 10};
  return scene;
}

Cloth cloth_at_rest(double stretch = 1) {
  Cloth cloth{flat_ribbon(size.grid), Matrix3Xd::Zero(3, size.grid.particle_count()), 0.5};
  cloth.positions.row(0) *= stretch;
  return cloth;
}

TwoHands hands_of(const Scene& scene) {
  return {scene, size, cloth_at_rest()};
}

TEST(TwoHands, pull_with_all_of_the_force_whatever_the_stretch_unless_they_yield) {
  Scene scene = scene_of_hands();
  const Cloth stretched = cloth_at_rest(1.05);
  const Matrix3Xd stubborn = hands_of(scene).pull(stretched);
  EXPECT_GT(stubborn.norm(), 0);
  scene.fastening->yield_strain = 0.05;
  TwoHands yielding = hands_of(scene);
  EXPECT_TRUE(yielding.pull(stretched).isApprox(0.5 * stubborn));
  EXPECT_NEAR(yielding.force_fraction(), 0.5, 1e-9);
}

// By hand: what grows by five times itself a second doubles in 0.14 s.
TEST(TwoHands, ease_by_half_and_then_pull_more_and_more_at_any_step) {
  for (const double step_s : {0.02, 0.01, 0.001}) {
    Scene scene = scene_of_hands();
    scene.time.step_s = step_s;
    const Cloth cloth = cloth_at_rest();
    TwoHands hands = hands_of(scene);
    const Matrix3Xd all = hands.pull(cloth);
    hands.ease();
    EXPECT_TRUE(hands.pull(cloth).isApprox(0.5 * all));
    EXPECT_EQ(hands.force_fraction(), 0.5);
    int steps = 0;
    for (; hands.force_fraction() < 1 && steps < 1000; ++steps) {
      hands.follow(cloth);
      hands.pull(cloth);
    }
    EXPECT_NEAR(steps * step_s, std::log(2) / 5, 0.022) << step_s;
  }
}

TEST(TwoHands, with_a_speed_limit_do_not_pull_what_is_too_fast) {
  Scene scene = scene_of_hands();
  scene.fastening->max_speed_m_s = 1;
  Cloth cloth = cloth_at_rest();
  cloth.velocities.row(0) = 2 * hands_of(scene_of_hands()).pull(cloth).row(0).cwiseSign();
  EXPECT_EQ(hands_of(scene).pull(cloth).norm(), 0);
}

// Hands that pull for `steps` steps, in each of which the ribbon moves so far along their pull, and
// is then put back.
void pull(TwoHands& hands, int steps, double moved_m) {
  Cloth cloth = cloth_at_rest();
  for (int step = 0; step < steps; ++step) {
    const Eigen::RowVectorXd direction = hands.pull(cloth).row(0).cwiseSign();
    cloth.positions.row(0) += moved_m * direction;
    hands.follow(cloth);
    cloth.positions.row(0) -= moved_m * direction;
  }
}

// By hand: those who want at most 1 m/s and get it lack nothing.
TEST(TwoHands, command_no_more_than_the_speed_limit) {
  Scene scene = scene_of_hands();
  scene.fastening->speed_m_s = 1000;
  scene.fastening->max_speed_m_s = 1;
  scene.air_resistance_per_s = 1000;
  TwoHands hands = hands_of(scene);
  pull(hands, 30, 0.1);
  EXPECT_NEAR(hands.progress(), 1, 1e-2);
}

TEST(TwoHands, are_done_when_nothing_followed_for_two_seconds) {
  TwoHands hands = hands_of(scene_of_hands());
  for (int step = 0; step < 20; ++step) {
    EXPECT_FALSE(hands.are_done()) << "too early to tell";
    pull(hands, 1, 0);
  }
  EXPECT_TRUE(hands.are_done());
  EXPECT_EQ(hands.progress(), 0);
}

TEST(TwoHands, are_not_done_while_the_ribbon_springs_back) {
  TwoHands hands = hands_of(scene_of_hands());
  pull(hands, 40, -0.05);
  EXPECT_LT(hands.progress(), -0.03);
  EXPECT_FALSE(hands.are_done());
}

}  // namespace ribbon::two_hands_test
