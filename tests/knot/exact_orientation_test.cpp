#include "knot/exact_orientation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace ribbon::exact_orientation_test {

Place point(double x, double y, double z) {
  return Place::point({x, y, z});
}
Place direction(double x, double y, double z) {
  return Place::direction({x, y, z});
}

constexpr double one_and_a_bit = 1 + std::numeric_limits<double>::epsilon();

TEST(ExactOrientation, counter_clockwise_seen_from_the_fourth_place_is_positive) {
  const Place a = point(0, 0, 0);
  const Place b = point(1, 0, 0);
  const Place c = point(0, 1, 0);
  EXPECT_EQ(orientation(a, b, c, point(0.3, 0.3, 1)), 1);
  EXPECT_EQ(orientation(a, b, c, point(0.3, 0.3, -1)), -1);
  EXPECT_EQ(orientation(a, b, c, point(7, -3, 0)), 0);
}

TEST(ExactOrientation, every_swap_turns_the_sign) {
  const std::array<Place, 4> places{point(1, 2, 3), direction(1, 0, -1), point(0, 5, 1),
                                    direction(2, 1, 1)};
  const auto& [a, b, c, d] = places;
  const int sign = orientation(a, b, c, d);
  ASSERT_NE(sign, 0);
  EXPECT_EQ(orientation(b, a, c, d), -sign);
  EXPECT_EQ(orientation(c, b, a, d), -sign);
  EXPECT_EQ(orientation(d, b, c, a), -sign);
  EXPECT_EQ(orientation(a, c, b, d), -sign);
  EXPECT_EQ(orientation(b, c, a, d), sign);
}

TEST(ExactOrientation, a_direction_is_what_a_far_point_along_it_is) {
  const Place a = point(1, 2, 3);
  const Place b = point(-1, 0.5, 2);
  const Place c = point(0, 4, -2);
  for (const Eigen::Vector3d& ray :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-3, 1, 2), Eigen::Vector3d(0.1, -7, 1)}) {
    const Place far = Place::point(1e6 * ray);
    EXPECT_EQ(orientation(a, b, c, Place::direction(ray)), orientation(a, b, c, far));
    EXPECT_EQ(orientation(Place::direction(ray), b, c, a), orientation(far, b, c, a));
  }
}

TEST(ExactOrientation, four_directions_have_none) {
  EXPECT_EQ(
      orientation(direction(1, 0, 0), direction(0, 1, 0), direction(0, 0, 1), direction(1, 1, 1)),
      0);
}

TEST(ExactOrientation, the_last_bit_decides) {
  // d lies in the plane x + y + z = 1 but for the last bit of one coordinate.
  const Place a = point(1, 0, 0);
  const Place b = point(0, 1, 0);
  const Place c = point(0, 0, 1);
  const double third = 0.3333740234375;  // few bits, so that the sum below is exact
  const double rest = 1 - 2 * third;
  EXPECT_EQ(orientation(a, b, c, point(third, third, rest)), 0);
  EXPECT_EQ(orientation(a, b, c, point(third, third, std::nextafter(rest, 1))), 1);
  EXPECT_EQ(orientation(a, b, c, point(third, third, std::nextafter(rest, 0))), -1);
}

TEST(ExactOrientation, points_of_one_slanted_plane_have_none) {
  // Their volumes have more digits than a double.
  std::mt19937 random(10);
  std::uniform_int_distribution<int> far(-(1 << 27), 1 << 27);
  const auto anywhere = [&] { return Eigen::Vector3d(far(random), far(random), far(random)); };
  for (int round = 0; round < 100; ++round) {
    // Every second time, so small that products lose digits below the smallest normal double.
    const double scale = round % 2 == 0 ? 1 : std::ldexp(1.0, -375);
    const Eigen::Vector3d a = scale * anywhere();
    const Eigen::Vector3d b = scale * anywhere();
    const Eigen::Vector3d c = scale * anywhere();
    EXPECT_EQ(orientation(Place::point(a), Place::point(b), Place::point(c),
                          Place::point(a + 3 * (b - a) - 5 * (c - a))),
              0);
  }
}

TEST(ExactOrientation, far_from_the_origin_the_last_bit_decides) {
  const double far = 1e9;
  EXPECT_EQ(orientation(point(far, far, far), point(far + 1, far, far), point(far, far + 1, far),
                        point(far + 0.5, far + 0.5, std::nextafter(far, 2 * far))),
            1);
}

TEST(ExactOrientation, products_too_small_for_a_double_keep_their_sign) {
  const double tiny = 1e-200;
  EXPECT_EQ(orientation(point(0, 0, 0), point(tiny, 0, 0), point(0, tiny, 0), point(0, 0, tiny)),
            1);
  EXPECT_EQ(orientation(point(0, 0, 0), point(tiny, 0, 0), point(0, tiny, 0), point(0, 0, -tiny)),
            -1);
}

TEST(OrderAlong, tells_which_line_is_met_first) {
  const Place p = point(0, 0, 0);
  const Place q = point(4, 0, 0);
  const Place view = direction(0, 0, 1);
  const auto upright = [](double x, double z, int which) {
    return point(x, which == 0 ? -1 : 1, z);
  };
  const auto order = [&](double one, double other) {
    return order_along(p, q, upright(one, 5, 0), upright(one, 5, 1), upright(other, -3, 1),
                       upright(other, -3, 0), view);
  };
  EXPECT_EQ(order(1, 3), -1);
  EXPECT_EQ(order(3, 1), 1);
  EXPECT_EQ(order(2, 2), 0);
  EXPECT_EQ(order(1, one_and_a_bit), -1);
  EXPECT_EQ(order(one_and_a_bit, 1), 1);
}

TEST(OrderAlong, lines_through_one_point_are_met_together) {
  // Their areas have more digits than a double.
  std::mt19937 random(8);
  std::uniform_int_distribution<int> far(1, 1 << 28);
  const Place p = point(0, 0, 0);
  const Place q = point(3e8, 9e8, 0);
  for (int round = 0; round < 50; ++round) {
    const int share = far(random);
    const Eigen::Vector3d met(share, 3.0 * share, 0);
    const auto beside = [&] { return Eigen::Vector3d(far(random), -far(random), far(random)); };
    const Eigen::Vector3d one = beside();
    const Eigen::Vector3d other = beside();
    EXPECT_EQ(
        order_along(p, q, Place::point(met + one), Place::point(met - 3 * one),
                    Place::point(met + 5 * other), Place::point(met - other), direction(0, 0, 1)),
        0);
  }
}

TEST(OrderAlong, rays_have_an_order_too) {
  const Place from_infinity = direction(-1, 0, 0);
  const Place q = point(0, 0, 0);
  const auto order = [&](double one, double other) {
    return order_along(from_infinity, q, point(one, -1, 0), point(one, 1, 0), point(other, -1, 1),
                       point(other, 1, 1), direction(0, 0, 1));
  };
  EXPECT_EQ(order(-9, -2), -1);
  EXPECT_EQ(order(-2, -9), 1);
}

}  // namespace ribbon::exact_orientation_test
