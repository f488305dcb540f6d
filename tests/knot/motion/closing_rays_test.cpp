#include "knot/motion/closing_rays.h"

#include <gtest/gtest.h>

#include "knot/knotted_curves.h"

namespace ribbon::closing_rays_test {

RibbonCurves curves_along(const Curve& curve) {
  return ribbon_curves({static_cast<int>(curve.cols()), 5}, ribbon_along(curve, 5, 0.2));
}

TEST(ClosingRays, lead_outwards) {
  ClosingRays rays;
  rays.start(curves_along(overhand_knot(200)));
  EXPECT_LT(rays.directions()[0].x(), -0.5);
  EXPECT_GT(rays.directions()[1].x(), 0.5);
  EXPECT_FALSE(rays.buried()[0] || rays.buried()[1]);
}

TEST(ClosingRays, keep_their_direction_while_nothing_comes_in_between) {
  ClosingRays rays;
  RibbonCurves before = curves_along(overhand_knot(200));
  rays.start(before);
  const auto directions = rays.directions();
  for (int step = 1; step <= 20; ++step) {
    RibbonCurves now = curves_along(overhand_knot(200, 6 + 0.3 * step));
    rays.follow(before, now);
    EXPECT_EQ(rays.directions(), directions);
    before = std::move(now);
  }
}

// A line along x whose last part swings round and comes through the ray of its first end.
Curve swinging(double angle) {
  return sampled(120, [angle](double way) {
    if (way < 0.25) return Eigen::Vector3d(4 * way - 1, 0, 0);
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    const double out = 12 * (way - 0.25);
    return Eigen::Vector3d(x * out, y * out, 0.8 * std::min(1.0, 3 * out) - 0.8 * out / 9 * 2);
  });
}

TEST(ClosingRays, turn_out_of_the_way_of_what_comes) {
  ClosingRays rays;
  RibbonCurves before = curves_along(swinging(0));
  rays.start(before);
  const Eigen::Vector3d at_first = rays.directions()[0];
  for (int step = 1; step <= 60; ++step) {
    RibbonCurves now = curves_along(swinging(std::numbers::pi * step / 30));
    rays.follow(before, now);
    before = std::move(now);
  }
  EXPECT_FALSE(rays.buried()[0] || rays.buried()[1]);
  EXPECT_NE(rays.directions()[0], at_first);
}

TEST(ClosingRays, an_end_in_a_ball_of_ribbon_is_buried_and_stays_so) {
  // From the middle of a sphere to one pole, wound round it 170 times, and away from the other one.
  const auto wound = [](double windings, double offset) {
    return sampled(3000, [&](double way) {
      if (way == 0) return Eigen::Vector3d(0, offset, 0);
      if (way == 1) return Eigen::Vector3d(0, offset, -5);
      const double down = std::numbers::pi * way;
      const double round = 2 * std::numbers::pi * windings * way + offset;
      return Eigen::Vector3d(std::sin(down) * std::cos(round), std::sin(down) * std::sin(round),
                             std::cos(down));
    });
  };
  const auto ball = [&](double windings) {
    return RibbonCurves{wound(windings, 0), wound(windings, -1e-4), wound(windings, 1e-4),
                        wound(windings, 0.5e-4)};
  };
  ClosingRays rays;
  rays.start(ball(20));
  EXPECT_FALSE(rays.buried()[0]);
  rays = {};
  rays.start(ball(170));
  EXPECT_TRUE(rays.buried()[0]);
  EXPECT_FALSE(rays.buried()[1]);
  rays.follow(ball(170), ball(20));
  EXPECT_TRUE(rays.buried()[0]);
}

}  // namespace ribbon::closing_rays_test
