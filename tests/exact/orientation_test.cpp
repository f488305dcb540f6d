#include "exact/orientation.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <random>

namespace ribbon::orientation_test {

ProjectivePoint point(double x, double y, double z) {
  return ProjectivePoint::point({x, y, z});
}
ProjectivePoint direction(double x, double y, double z) {
  return ProjectivePoint::direction({x, y, z});
}

constexpr double one_and_a_bit = 1 + std::numeric_limits<double>::epsilon();

TEST(Orientation, counter_clockwise_seen_from_the_fourth_point_is_positive) {
  const ProjectivePoint a = point(0, 0, 0);
  const ProjectivePoint b = point(1, 0, 0);
  const ProjectivePoint c = point(0, 1, 0);
  EXPECT_EQ(orientation(a, b, c, point(0.3, 0.3, 1)), 1);
  EXPECT_EQ(orientation(a, b, c, point(0.3, 0.3, -1)), -1);
  EXPECT_EQ(orientation(a, b, c, point(7, -3, 0)), 0);
}

TEST(Orientation, every_swap_turns_the_sign) {
  const std::array<ProjectivePoint, 4> points{point(1, 2, 3), direction(1, 0, -1), point(0, 5, 1),
                                              direction(2, 1, 1)};
  const auto& [a, b, c, d] = points;
  const int sign = orientation(a, b, c, d);
  ASSERT_NE(sign, 0);
  EXPECT_EQ(orientation(b, a, c, d), -sign);
  EXPECT_EQ(orientation(c, b, a, d), -sign);
  EXPECT_EQ(orientation(d, b, c, a), -sign);
  EXPECT_EQ(orientation(a, c, b, d), -sign);
  EXPECT_EQ(orientation(b, c, a, d), sign);
}

TEST(Orientation, a_direction_is_what_a_far_point_along_it_is) {
  const ProjectivePoint a = point(1, 2, 3);
  const ProjectivePoint b = point(-1, 0.5, 2);
  const ProjectivePoint c = point(0, 4, -2);
  for (const Eigen::Vector3d& ray :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-3, 1, 2), Eigen::Vector3d(0.1, -7, 1)}) {
    const ProjectivePoint far = ProjectivePoint::point(1e6 * ray);
    EXPECT_EQ(orientation(a, b, c, ProjectivePoint::direction(ray)), orientation(a, b, c, far));
    EXPECT_EQ(orientation(ProjectivePoint::direction(ray), b, c, a), orientation(far, b, c, a));
  }
}

TEST(Orientation, four_directions_have_none) {
  EXPECT_EQ(
      orientation(direction(1, 0, 0), direction(0, 1, 0), direction(0, 0, 1), direction(1, 1, 1)),
      0);
}

TEST(Orientation, the_last_bit_decides) {
  // d lies in the plane x + y + z = 1 but for the last bit of one coordinate.
  const ProjectivePoint a = point(1, 0, 0);
  const ProjectivePoint b = point(0, 1, 0);
  const ProjectivePoint c = point(0, 0, 1);
  const double third = 0.3333740234375;  // few bits, so that the sum below is exact
  const double rest = 1 - 2 * third;
  EXPECT_EQ(orientation(a, b, c, point(third, third, rest)), 0);
  EXPECT_EQ(orientation(a, b, c, point(third, third, std::nextafter(rest, 1))), 1);
  EXPECT_EQ(orientation(a, b, c, point(third, third, std::nextafter(rest, 0))), -1);
}

TEST(Orientation, points_of_one_slanted_plane_have_none) {
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
    EXPECT_EQ(
        orientation(ProjectivePoint::point(a), ProjectivePoint::point(b), ProjectivePoint::point(c),
                    ProjectivePoint::point(a + 3 * (b - a) - 5 * (c - a))),
        0);
  }
}

TEST(Orientation, far_from_the_origin_the_last_bit_decides) {
  const double far = 1e9;
  EXPECT_EQ(orientation(point(far, far, far), point(far + 1, far, far), point(far, far + 1, far),
                        point(far + 0.5, far + 0.5, std::nextafter(far, 2 * far))),
            1);
}

TEST(Orientation, products_too_small_for_a_double_keep_their_sign) {
  const double tiny = 1e-200;
  EXPECT_EQ(orientation(point(0, 0, 0), point(tiny, 0, 0), point(0, tiny, 0), point(0, 0, tiny)),
            1);
  EXPECT_EQ(orientation(point(0, 0, 0), point(tiny, 0, 0), point(0, tiny, 0), point(0, 0, -tiny)),
            -1);
}

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float tiniest = std::numeric_limits<float>::denorm_min();
constexpr float hugest = std::numeric_limits<float>::max();

TEST(SideOfPlane, counter_clockwise_seen_from_the_fourth_point_is_positive) {
  const Vector3f a(0, 0, 0);
  const Vector3f b(1, 0, 0);
  const Vector3f c(0, 1, 0);
  EXPECT_EQ(side_of_plane(a, b, c, {0.2F, 0.2F, 5}), 1);
  EXPECT_EQ(side_of_plane(a, b, c, {0.2F, 0.2F, -5}), -1);
  EXPECT_EQ(side_of_plane(a, b, c, {7, -3, 0}), 0);
  EXPECT_EQ(turn({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(turn({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(turn({0, 0}, {1, 2}, {3, 6}), 0);
}

// One unit in the last place off the plane x + y + z = 3 and the line y = x / 3: rounding alone
// would say anything.
TEST(SideOfPlane, the_last_binary_digit_decides) {
  const Vector3f a(3, 0, 0);
  const Vector3f b(0, 3, 0);
  const Vector3f c(0, 0, 3);
  const float x = 0.7F;
  const float y = 1.1F;
  const float z = 3 - x - y;  // rounded
  // In double the exact sum of three singles of about the same size is representable.
  const double excess = static_cast<double>(x) + y + z - 3;
  EXPECT_EQ(side_of_plane(a, b, c, {x, y, z}), excess > 0 ? 1 : excess < 0 ? -1 : 0);
  const float on_plane = 1.2F;  // 0.6 + 0.6 + ... chosen so that 2 v is exact
  EXPECT_EQ(side_of_plane({on_plane, 0, 0}, {0, on_plane, 0}, {0, 0, on_plane},
                          {on_plane / 2, on_plane / 2, 0}),
            0);
  EXPECT_EQ(side_of_plane({on_plane, 0, 0}, {0, on_plane, 0}, {0, 0, on_plane},
                          {on_plane / 2, on_plane / 2, tiniest}),
            1);
  EXPECT_EQ(side_of_plane({on_plane, 0, 0}, {0, on_plane, 0}, {0, 0, on_plane},
                          {on_plane / 2, on_plane / 2, -tiniest}),
            -1);
  EXPECT_EQ(turn({0, 0}, {1e30F, 1e30F}, {1e-30F, 1e-30F}), 0);
  EXPECT_EQ(turn({0, 0}, {1e30F, 1e30F}, {1e-30F, std::nextafter(1e-30F, 1.0F)}), 1);
  EXPECT_EQ(turn({0, 0}, {1e30F, 1e30F}, {1e-30F, std::nextafter(1e-30F, 0.0F)}), -1);
}

TEST(SideOfPlane, the_tiniest_and_the_largest_coordinates_are_exact) {
  const Vector3f o(0, 0, 0);
  const Vector3f x(tiniest, 0, 0);
  const Vector3f y(0, tiniest, 0);
  EXPECT_EQ(side_of_plane(o, x, y, {0, 0, tiniest}), 1);
  EXPECT_EQ(side_of_plane(o, x, y, {hugest, hugest, -tiniest}), -1);
  EXPECT_EQ(side_of_plane({-hugest, 0, 0}, {hugest, 0, 0}, {0, hugest, 0}, {0, 0, hugest}), 1);
  EXPECT_EQ(side_of_plane({-hugest, -hugest, -hugest}, {hugest, hugest, hugest},
                          {0, hugest, tiniest}, {0, hugest, tiniest}),
            0);
  // Four points of the plane x = y, whose determinant is made of products that cancel.
  EXPECT_EQ(side_of_plane({tiniest, tiniest, hugest}, {hugest, hugest, 0}, {1, 1, 7},
                          {-hugest, -hugest, tiniest}),
            0);
  EXPECT_NE(side_of_plane({tiniest, 2 * tiniest, hugest}, {hugest, hugest, 0}, {1, 1, 7},
                          {-hugest, -hugest, tiniest}),
            0);
}

// So small that no double precision settles anything: the integers decide.
int side_in_integers(const Vector3f& a, const Vector3f& b, const Vector3f& c, const Vector3f& d) {
  const auto tiny = [](const Vector3f& point) {
    return ProjectivePoint::point(std::ldexp(1.0, -500) * point.cast<double>());
  };
  return orientation(tiny(a), tiny(b), tiny(c), tiny(d));
}
int turn_in_integers(const Vector2f& a, const Vector2f& b, const Vector2f& c) {
  const auto flat = [](const Vector2f& point) { return Vector3f(point.x(), point.y(), 0); };
  return side_in_integers(flat(a), flat(b), flat(c), flat(a) + Vector3f::UnitZ());
}

TEST(SideOfPlane, the_exact_signs_agree_where_doubles_suffice) {
  EXPECT_EQ(side_in_integers({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(side_in_integers({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}), -1);
  EXPECT_EQ(side_in_integers({-0.5F, 2, 1e-20F}, {1, -3, 1e20F}, {1, -3, 1e20F}, {0, 0, 1}), 0);
  EXPECT_EQ(turn_in_integers({0.25F, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(turn_in_integers({0, 0}, {0, 0}, {0, 0}), 0);
  EXPECT_EQ(turn_in_integers({-1, 1}, {0, 0}, {1, 1}), 1);
}

using Rational = boost::multiprecision::cpp_rational;

int sign_in_rationals(const Vector3f& a, const Vector3f& b, const Vector3f& c, const Vector3f& d) {
  Eigen::Matrix<Rational, 3, 4> x;
  for (int k = 0; k < 3; ++k) {
    x(k, 0) = Rational(a[k]);
    x(k, 1) = Rational(b[k]) - x(k, 0);
    x(k, 2) = Rational(c[k]) - x(k, 0);
    x(k, 3) = Rational(d[k]) - x(k, 0);
  }
  Rational determinant = 0;
  for (int k = 0; k < 3; ++k)
    determinant +=
        x(k, 1) * (x((k + 1) % 3, 2) * x((k + 2) % 3, 3) - x((k + 2) % 3, 2) * x((k + 1) % 3, 3));
  return determinant.sign();
}

// Numbers of all sizes a float can have, with few digits, so that sums cancel now and then.
class RandomFloats {
 public:
  float operator()() {
    const int digits = static_cast<int>(random_() % 33) - 16;
    const int exponent = static_cast<int>(random_() % 270) - 149;
    return std::ldexp(static_cast<float>(digits), exponent);
  }
  Vector3f point() { return {(*this)(), (*this)(), (*this)()}; }

 private:
  std::mt19937 random_{11};
};

TEST(SideOfPlane, agrees_with_rational_numbers_on_points_of_all_sizes) {
  RandomFloats random;
  for (int trial = 0; trial < 3000; ++trial) {
    const Vector3f a = random.point();
    const Vector3f b = random.point();
    const Vector3f c = random.point();
    const Vector3f d = random.point();
    ASSERT_EQ(side_of_plane(a, b, c, d), sign_in_rationals(a, b, c, d));
    ASSERT_EQ(side_in_integers(a, b, c, d), sign_in_rationals(a, b, c, d));
  }
}

// The fourth point is on the plane of the others but for its rounding.
TEST(SideOfPlane, agrees_with_rational_numbers_on_nearly_flat_points) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> coordinate(-1, 1);
  const auto point = [&] {
    return Vector3f(coordinate(random), coordinate(random), coordinate(random));
  };
  int flat = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Vector3f a = point();
    const Vector3f b = point();
    const Vector3f c = point();
    const Vector3f d = trial % 2 == 0 ? Vector3f(a + 0.5F * (b - a) + 0.25F * (c - a))
                                      : Vector3f(b * 0.5F + c * 0.5F);
    const int expected = sign_in_rationals(a, b, c, d);
    ASSERT_EQ(side_of_plane(a, b, c, d), expected);
    ASSERT_EQ(side_in_integers(a, b, c, d), expected);
    ASSERT_EQ(turn_in_integers(a.head<2>(), b.head<2>(), c.head<2>()),
              turn(a.head<2>(), b.head<2>(), c.head<2>()));
    if (expected == 0) ++flat;
  }
  EXPECT_GT(flat, 0);
  EXPECT_LT(flat, 2500);
}

TEST(OrderAlong, tells_which_line_is_met_first) {
  const ProjectivePoint p = point(0, 0, 0);
  const ProjectivePoint q = point(4, 0, 0);
  const ProjectivePoint view = direction(0, 0, 1);
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
  const ProjectivePoint p = point(0, 0, 0);
  const ProjectivePoint q = point(3e8, 9e8, 0);
  for (int round = 0; round < 50; ++round) {
    const int share = far(random);
    const Eigen::Vector3d met(share, 3.0 * share, 0);
    const auto beside = [&] { return Eigen::Vector3d(far(random), -far(random), far(random)); };
    const Eigen::Vector3d one = beside();
    const Eigen::Vector3d other = beside();
    EXPECT_EQ(
        order_along(p, q, ProjectivePoint::point(met + one), ProjectivePoint::point(met - 3 * one),
                    ProjectivePoint::point(met + 5 * other), ProjectivePoint::point(met - other),
                    direction(0, 0, 1)),
        0);
  }
}

TEST(OrderAlong, rays_have_an_order_too) {
  const ProjectivePoint from_infinity = direction(-1, 0, 0);
  const ProjectivePoint q = point(0, 0, 0);
  const auto order = [&](double one, double other) {
    return order_along(from_infinity, q, point(one, -1, 0), point(one, 1, 0), point(other, -1, 1),
                       point(other, 1, 1), direction(0, 0, 1));
  };
  EXPECT_EQ(order(-9, -2), -1);
  EXPECT_EQ(order(-2, -9), 1);
}

}  // namespace ribbon::orientation_test
