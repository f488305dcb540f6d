#include "player/picture/strokes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ribbon::strokes_test {

const Color white(1, 1, 1);
const Color black(0, 0, 0);

Picture drawn(const std::function<void(Strokes&)>& add, PictureSize size = {20, 10}) {
  Picture picture = blank_picture(size, white);
  Strokes strokes(size);
  add(strokes);
  strokes.draw(black, picture);
  return picture;
}

// Of a pixel, 0 to 1.
double ink(const Picture& picture, int x, int y) {
  return 1 - *picture.pixel(x, y) / 255.0;
}

double all_ink(const Picture& picture) {
  double sum = 0;
  for (int y = 0; y < picture.size.height; ++y)
    for (int x = 0; x < picture.size.width; ++x) sum += ink(picture, x, y);
  return sum;
}

TEST(Strokes, a_line_along_pixels_fills_them_and_no_others) {
  const Picture picture = drawn([](Strokes& strokes) {
    strokes.add({2.5F, 4.5F}, {9.5F, 4.5F}, 1);
  });
  for (int y = 0; y < 10; ++y)
    for (int x = 3; x < 9; ++x) EXPECT_NEAR(ink(picture, x, y), y == 4 ? 1 : 0, 0.01) << x << y;
  EXPECT_EQ(ink(picture, 1, 4), 0);
  EXPECT_EQ(ink(picture, 11, 4), 0);
}

TEST(Strokes, between_two_rows_a_line_covers_half_of_each) {
  const Picture picture = drawn([](Strokes& strokes) { strokes.add({0, 4}, {20, 4}, 1); });
  EXPECT_NEAR(ink(picture, 10, 3), 0.5, 0.01);
  EXPECT_NEAR(ink(picture, 10, 4), 0.5, 0.01);
}

TEST(Strokes, lines_take_as_much_ink_as_they_are_wide_in_any_direction) {
  for (const float width : {0.5F, 1.0F, 2.0F, 3.5F})
    for (const float angle : {0.0F, 0.3F, 0.8F, 1.5F}) {
      const Eigen::Vector2f half = 30 * Eigen::Vector2f(std::cos(angle), std::sin(angle));
      const Eigen::Vector2f middle(50.3F, 50.7F);
      const auto add = [&](Strokes& strokes) { strokes.add(middle - half, middle + half, width); };
      EXPECT_NEAR(all_ink(drawn(add, {100, 100})), 60 * width, 3 * width + 1)
          << width << " " << angle;
    }
}

TEST(Strokes, where_lines_join_or_cross_ink_is_laid_once) {
  const auto once = drawn([](Strokes& strokes) { strokes.add({2, 5}, {18, 5}, 1.5F, 0.5F); });
  const auto twice = drawn([](Strokes& strokes) {
    strokes.add({2, 5}, {11, 5}, 1.5F, 0.5F);
    strokes.add({9, 5}, {18, 5}, 1.5F, 0.5F);
  });
  EXPECT_EQ(once.rgb, twice.rgb);
  EXPECT_NEAR(ink(once, 10, 5), 0.5, 0.15);
}

TEST(Strokes, what_is_outside_is_left_out) {
  const auto outside = drawn([](Strokes& strokes) {
    strokes.add({-1e6F, -5}, {1e6F, -5}, 2);
    strokes.add({-40, -40}, {-20, 1e5F}, 3);
    strokes.add({21.5F, 0}, {22, 10}, 1);
  });
  EXPECT_EQ(all_ink(outside), 0);
  const auto through = drawn([](Strokes& strokes) { strokes.add({-1e4F, 5.5F}, {1e4F, 5.5F}, 1); });
  EXPECT_NEAR(all_ink(through), 20, 0.1);
}

TEST(Strokes, a_point_is_a_dot) {
  const auto dot = drawn([](Strokes& strokes) { strokes.add({5.5F, 5.5F}, {5.5F, 5.5F}, 3); });
  EXPECT_EQ(ink(dot, 5, 5), 1);
  EXPECT_NEAR(all_ink(dot), 7, 1.5);
}

}  // namespace ribbon::strokes_test
