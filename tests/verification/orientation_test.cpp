#include "verification/orientation.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "verification/exact_orientation.h"

namespace ribbon::orientation_test {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float tiniest = std::numeric_limits<float>::denorm_min();
constexpr float hugest = std::numeric_limits<float>::max();

TEST(Orientation, counter_clockwise_seen_from_the_fourth_point_is_positive) {
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
TEST(Orientation, the_last_binary_digit_decides) {
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

TEST(Orientation, the_tiniest_and_the_largest_coordinates_are_exact) {
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

TEST(Orientation, the_exact_signs_agree_where_doubles_suffice) {
  EXPECT_EQ(exact_side_of_plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(exact_side_of_plane({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}), -1);
  EXPECT_EQ(exact_side_of_plane({-0.5F, 2, 1e-20F}, {1, -3, 1e20F}, {1, -3, 1e20F}, {0, 0, 1}), 0);
  EXPECT_EQ(exact_turn({0.25F, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(exact_turn({0, 0}, {0, 0}, {0, 0}), 0);
  EXPECT_EQ(exact_turn({-1, 1}, {0, 0}, {1, 1}), 1);
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

TEST(Orientation, agrees_with_rational_numbers_on_points_of_all_sizes) {
  RandomFloats random;
  for (int trial = 0; trial < 3000; ++trial) {
    const Vector3f a = random.point();
    const Vector3f b = random.point();
    const Vector3f c = random.point();
    const Vector3f d = random.point();
    ASSERT_EQ(side_of_plane(a, b, c, d), sign_in_rationals(a, b, c, d));
    ASSERT_EQ(exact_side_of_plane(a, b, c, d), sign_in_rationals(a, b, c, d));
  }
}

// The fourth point is on the plane of the others but for its rounding.
TEST(Orientation, agrees_with_rational_numbers_on_nearly_flat_points) {
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
    ASSERT_EQ(exact_side_of_plane(a, b, c, d), expected);
    ASSERT_EQ(exact_turn(a.head<2>(), b.head<2>(), c.head<2>()),
              turn(a.head<2>(), b.head<2>(), c.head<2>()));
    if (expected == 0) ++flat;
  }
  EXPECT_GT(flat, 0);
  EXPECT_LT(flat, 2500);
}

}  // namespace ribbon::orientation_test
