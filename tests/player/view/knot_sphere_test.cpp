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

TEST(KnotSphere, a_jump_is_followed_smoothly) {
  std::vector<double> times_s;
  std::vector<std::optional<Sphere>> spheres;
  for (int f = 0; f < 200; ++f) {
    times_s.push_back(f / 50.0);
    spheres.emplace_back(at_x(f < 100 ? 0 : 1));
  }
  const auto result = followed(times_s, spheres);
  EXPECT_FLOAT_EQ(result.front().center.x(), 0);
  EXPECT_FLOAT_EQ(result.back().center.x(), 1);
  for (std::size_t f = 1; f < result.size(); ++f) {
    EXPECT_GE(result[f].center.x(), result[f - 1].center.x());
    EXPECT_LT(result[f].center.x() - result[f - 1].center.x(), 0.05F);
  }
}

TEST(KnotSphere, frames_without_one_get_theirs_from_their_neighbours) {
  std::vector<double> times_s;
  std::vector<std::optional<Sphere>> spheres(40);
  for (int f = 0; f < 40; ++f) times_s.push_back(f);
  spheres[10] = at_x(0);
  spheres[20] = at_x(10);
  const auto result = followed(times_s, spheres);
  EXPECT_NEAR(result[0].center.x(), 0, 1e-6F);
  EXPECT_NEAR(result[15].center.x(), 5, 1e-4F);
  EXPECT_NEAR(result[39].center.x(), 10, 1e-6F);
}

}  // namespace ribbon::knot_sphere_test
