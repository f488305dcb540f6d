#include "verification/orientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "verification/exact_orientation.h"

namespace ribbon {
namespace {

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

}  // namespace
}  // namespace ribbon
