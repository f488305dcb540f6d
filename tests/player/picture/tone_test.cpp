#include "player/picture/tone.h"

#include <gtest/gtest.h>

namespace ribbon::tone_test {

LightPicture grey(const std::vector<float>& values) {
  LightPicture light{{static_cast<int>(values.size()), 1}, {}};
  light.pixels.reserve(values.size());
  for (const float value : values) light.pixels.emplace_back(Color::Constant(value));
  return light;
}

TEST(Tone, each_stop_doubles_the_light) {
  LightPicture light = grey({0.1F, 0.4F});
  apply({.exposure_stops = 2}, light);
  EXPECT_FLOAT_EQ(light.pixels[0][0], 0.4F);
  EXPECT_FLOAT_EQ(light.pixels[1][2], 1.6F);
}

TEST(Tone, a_soft_curve_keeps_the_dark_and_tells_bright_from_brighter) {
  LightPicture light = grey({0, 0.3F, 0.7F, 0.71F, 1, 2, 8, 1000});
  apply({.soft = true}, light);
  EXPECT_FLOAT_EQ(light.pixels[1][0], 0.3F);
  EXPECT_FLOAT_EQ(light.pixels[2][0], 0.7F);
  EXPECT_NEAR(light.pixels[3][0], 0.71F, 0.001F) << "no kink";
  for (std::size_t i = 1; i < light.pixels.size(); ++i) {
    EXPECT_GT(light.pixels[i][0], light.pixels[i - 1][0]);
    EXPECT_LT(light.pixels[i][0], 1);
  }
}

TEST(Tone, without_settings_nothing_changes) {
  LightPicture light = grey({0.5F, 3});
  apply({}, light);
  EXPECT_EQ(light.pixels[1][1], 3);
}

}  // namespace ribbon::tone_test
