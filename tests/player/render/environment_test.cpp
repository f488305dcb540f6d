#include "player/render/environment.h"

#include <gtest/gtest.h>

#include "files/temporary_folder.h"
#include "player/picture/png_encoder.h"

namespace ribbon::environment_test {

// A panorama of 64 x 32, each pixel's colour a function of its column and row.
template <class Function>
Environment environment_of(const Function& color) {
  Picture picture = blank_picture({64, 32}, Color::Zero());
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x)
      for (int channel = 0; channel < 3; ++channel)
        picture.pixel(x, y)[channel] = srgb_byte(color(x, y)[channel]);
  const auto file = temporary_file("panorama.png");
  EXPECT_TRUE(write_png(file, picture));
  return Environment(Texture::read(file).value());
}

TEST(Environment, an_even_one_is_as_bright_from_everywhere) {
  const Environment even = environment_of([](int, int) { return Color(0.2F, 0.4F, 0.6F); });
  for (const Eigen::Vector3f& direction :
       {Eigen::Vector3f(0, 1, 0), Eigen::Vector3f(0, 0, 1), Eigen::Vector3f(0.6F, 0, -0.8F)})
    for (int channel = 0; channel < 3; ++channel) {
      const float expected = 0.2F * static_cast<float>(channel + 1);
      EXPECT_NEAR(even.sky(direction)[channel], expected, 0.01F);
      EXPECT_NEAR(even.mean_sky(direction)[channel], expected, 0.01F);
    }
}

TEST(Environment, its_middle_lies_in_front_and_its_top_above) {
  const Environment sides = environment_of([](int x, int y) {
    return Color(x >= 28 && x < 36 ? 1.0F : 0.0F, y < 16 ? 1.0F : 0.0F,
                 x > 44 && x < 52 ? 1.0F : 0.0F);
  });
  EXPECT_GT(sides.sky({0, 0, 1})[0], 0.9F);
  EXPECT_LT(sides.sky({0, 0, -1})[0], 0.1F);
  EXPECT_GT(sides.sky({0, 1, 0})[1], 0.9F);
  EXPECT_LT(sides.sky({0, -1, 0})[1], 0.1F);
  EXPECT_GT(sides.sky({1, 0, 0})[2], 0.9F) << "right of the middle is the right";
}

TEST(Environment, a_surface_gets_the_mean_of_what_it_faces) {
  // White above the horizon, black below: facing up all of it, upright half, down nothing.
  const Environment above =
      environment_of([](int, int y) { return Color::Constant(y < 16 ? 1 : 0).eval(); });
  EXPECT_NEAR(above.mean_sky({0, 1, 0})[0], 1, 0.07F);
  EXPECT_NEAR(above.mean_sky({0, 0, 1})[0], 0.5F, 0.02F);
  EXPECT_NEAR(above.mean_sky({0, -1, 0})[0], 0, 0.07F);
}

}  // namespace ribbon::environment_test
