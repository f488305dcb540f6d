#include "player/view/knot_sphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ribbon::knot_sphere_test {

constexpr RibbonGrid grid{200, 3};
constexpr float width_m = 0.1F;
constexpr float length_m = 4;

// A strip upright on the curve at(s), s from 0 to length_m.
template <class Curve>
Eigen::Matrix3Xf strip(const Curve& at) {
  Eigen::Matrix3Xf positions(3, grid.particle_count());
  for (int i = 0; i < grid.along; ++i)
    for (int j = 0; j < grid.across; ++j)
      positions.col(grid.particle(i, j)) =
          at(length_m * static_cast<float>(i) / (grid.along - 1)) +
          Eigen::Vector3f(0, width_m * (static_cast<float>(j) / (grid.across - 1) - 0.5F), 0);
  return positions;
}

TEST(KnotSphere, a_ribbon_that_meets_itself_nowhere_has_none) {
  const auto straight = strip([](float s) { return Eigen::Vector3f(s, 0, 0); });
  EXPECT_FALSE(knot_sphere(grid, width_m, length_m, straight));
  EXPECT_FALSE(knot_sphere(grid, 1e12F, length_m, straight)) << "however wide a header calls it";
}

TEST(KnotSphere, lies_where_the_ribbon_crosses_itself) {
  // A loop: straight on, once round a circle, straight on, touching where the circle closes.
  const auto loop = strip([](float s) -> Eigen::Vector3f {
    constexpr float radius = 0.3F;
    constexpr float round = 2 * std::numbers::pi_v<float> * radius;
    if (s < 1) return {s, 0, 0};
    if (s > 1 + round) return {s - round, 0, 0.02F};
    const float angle = (s - 1) / radius;
    return {1 + radius * std::sin(angle), 0, radius * (1 - std::cos(angle))};
  });
  const auto sphere = knot_sphere(grid, width_m, length_m, loop);
  ASSERT_TRUE(sphere);
  EXPECT_LT((sphere->center - Eigen::Vector3f(1, 0, 0)).norm(), width_m);
  EXPECT_LT(sphere->radius_m, 4 * width_m);
  EXPECT_GT(sphere->radius_m, width_m / 2);
}

Sphere at_x(float x) {
  return {Eigen::Vector3f(x, 0, 0), 1};
}

// The knot at x = 0, and from frame 100 on at x = 1; 50 frames a second.
FollowedKnot jumping(int frames) {
  FollowedKnot knot;
  for (int f = 0; f < frames; ++f) knot.add(f / 50.0, at_x(f < 100 ? 0 : 1));
  return knot;
}

TEST(FollowedKnot, a_jump_is_followed_smoothly) {
  const FollowedKnot knot = jumping(200);
  EXPECT_FLOAT_EQ(knot.at(0)->center.x(), 0);
  EXPECT_FLOAT_EQ(knot.at(199)->center.x(), 1);
  for (int f = 1; f < 200; ++f) {
    const float moved = knot.at(f)->center.x() - knot.at(f - 1)->center.x();
    EXPECT_GE(moved, 0);
    EXPECT_LT(moved, 0.05F);
  }
}

TEST(FollowedKnot, frames_without_one_get_theirs_from_their_neighbours) {
  FollowedKnot knot;
  for (int f = 0; f < 40; ++f)
    knot.add(f,
             f == 10 || f == 20 ? std::optional(at_x(static_cast<float>(f - 10))) : std::nullopt);
  EXPECT_NEAR(knot.at(0)->center.x(), 0, 1e-6F);
  EXPECT_NEAR(knot.at(15)->center.x(), 5, 1e-4F);
  EXPECT_NEAR(knot.at(39)->center.x(), 10, 1e-6F);
}

TEST(FollowedKnot, what_is_settled_stays_whatever_comes) {
  const FollowedKnot all = jumping(200);
  int settled = 0;
  for (int came = 1; came < 200; ++came) {
    const FollowedKnot knot = jumping(came);
    for (; settled < came && knot.is_settled(settled); ++settled)
      EXPECT_EQ(knot.at(settled)->center, all.at(settled)->center) << settled << " of " << came;
  }
  EXPECT_EQ(settled, 161) << "0.75 s after them are known of all but the last";
  EXPECT_NE(jumping(101).at(99)->center, all.at(99)->center) << "not yet settled";
}

TEST(FollowedKnot, waits_in_a_gap_and_knows_all_at_the_end) {
  FollowedKnot knot;
  knot.add(0, at_x(0));
  for (int f = 1; f < 10; ++f) knot.add(f, std::nullopt);
  EXPECT_FALSE(knot.is_settled(0));
  knot.add(10, at_x(1));
  EXPECT_TRUE(knot.is_settled(9));
  EXPECT_FALSE(knot.is_settled(10));
  knot.end();
  EXPECT_TRUE(knot.is_settled(10));
}

}  // namespace ribbon::knot_sphere_test
