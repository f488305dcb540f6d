#include "player/picture/color_map.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ribbon::color_map_test {

// CIE L*a*b* of a colour, by the formulas that lead there; the map was made by those that lead
// back.
Eigen::Array3d lab_of(const Color& color) {
  Eigen::Matrix3d xyz_from_rgb;
  xyz_from_rgb << 0.4124564, 0.3575761, 0.1804375,  //
      0.2126729, 0.7151522, 0.0721750,              //
      0.0193339, 0.1191920, 0.9503041;
  const Eigen::Array3d white(0.95047, 1, 1.08883);
  const Eigen::Array3d relative = (xyz_from_rgb * color.matrix().cast<double>()).array() / white;
  const Eigen::Array3d f = relative.unaryExpr(
      [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; });
  return {116 * f.y() - 16, 500 * (f.x() - f.y()), 200 * (f.y() - f.z())};
}

Eigen::Array3d lab_at(const ColorMap& map, int step, int steps) {
  return lab_of(map.at(static_cast<float>(step) / static_cast<float>(steps)));
}

void expect_even_steps(const ColorMap& map) {
  constexpr int steps = 64;
  double sum = 0;
  for (int k = 0; k < steps; ++k)
    sum += (lab_at(map, k + 1, steps) - lab_at(map, k, steps)).matrix().norm();
  for (int k = 0; k < steps; ++k)
    EXPECT_NEAR((lab_at(map, k + 1, steps) - lab_at(map, k, steps)).matrix().norm(), sum / steps,
                0.04 * sum / steps)
        << k;
}

TEST(LabColor, becomes_light_and_back) {
  for (const LabColor& lab :
       {LabColor{50, 0, 0}, LabColor{25, 30, -48}, LabColor{93, -10, 56}, LabColor{4, 1, -2}}) {
    const Eigen::Array3d back = lab_of(linear_light(lab));
    EXPECT_NEAR(back[0], lab.lightness, 0.01);
    EXPECT_NEAR(back[1], lab.green_red, 0.02);
    EXPECT_NEAR(back[2], lab.blue_yellow, 0.02);
  }
}

TEST(LabColor, white_is_white) {
  EXPECT_TRUE(linear_light({100, 0, 0}).isApprox(Color::Ones(), 1e-4F));
}

TEST(SequentialMap, grows_lighter_from_end_to_end) {
  for (int k = 0; k < 256; ++k)
    EXPECT_GT(lab_at(sequential_map(), k + 1, 256)[0], lab_at(sequential_map(), k, 256)[0] + 0.15)
        << k;
  EXPECT_NEAR(lab_at(sequential_map(), 0, 1)[0], 25, 0.1);
  EXPECT_NEAR(lab_at(sequential_map(), 1, 1)[0], 93, 0.1);
}

TEST(SequentialMap, takes_steps_of_one_size) {
  expect_even_steps(sequential_map());
}

TEST(DivergingMap, is_lightest_in_the_middle_and_equally_dark_at_both_ends) {
  for (int k = 0; k < 128; ++k) {
    EXPECT_GT(lab_at(diverging_map(), k + 1, 256)[0], lab_at(diverging_map(), k, 256)[0]);
    EXPECT_GT(lab_at(diverging_map(), 255 - k, 256)[0], lab_at(diverging_map(), 256 - k, 256)[0]);
  }
  EXPECT_NEAR(lab_at(diverging_map(), 0, 1)[0], lab_at(diverging_map(), 1, 1)[0], 0.2);
  const Eigen::Array3d middle = lab_at(diverging_map(), 1, 2);
  EXPECT_NEAR(middle[0], 88, 0.1);
  EXPECT_LT(std::hypot(middle[1], middle[2]), 3);  // nearly grey
}

TEST(ColorMap, beyond_its_ends_keeps_their_colours) {
  const ColorMap& map = sequential_map();
  for (const float low : {-1.0F, -HUGE_VALF, std::nanf("")})
    EXPECT_TRUE((map.at(low) == map.at(0)).all());
  for (const float high : {1.5F, HUGE_VALF}) EXPECT_TRUE((map.at(high) == map.at(1)).all());
}

TEST(ColorMap, reversed_begins_with_its_end) {
  const ColorMap reversed = sequential_map().reversed();
  for (const float place : {0.0F, 0.25F, 1.0F})
    EXPECT_TRUE(reversed.at(place).isApprox(sequential_map().at(1 - place), 1e-5F));
}

}  // namespace ribbon::color_map_test
