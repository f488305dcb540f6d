#include "player/render/backdrop_view.h"

#include <gtest/gtest.h>

#include "files/temporary_folder.h"
#include "player/picture/png_encoder.h"
#include "player/quads.h"
#include "player/render/render.h"
#include "player/view/orbit.h"

namespace ribbon::backdrop_view_test {

// Smooth in all directions: red to the right, green upwards, blue to the front.
std::shared_ptr<const Environment> smooth_environment() {
  Picture picture = blank_picture({128, 64}, Color::Zero());
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 128; ++x) {
      const double round = (x + 0.5) / 128 * 2 * 3.14159265 - 3.14159265;
      const double down = (y + 0.5) / 64 * 3.14159265;
      const Eigen::Vector3d direction(std::sin(down) * std::sin(round), std::cos(down),
                                      std::sin(down) * std::cos(round));
      for (int channel = 0; channel < 3; ++channel)
        picture.pixel(x, y)[channel] =
            srgb_byte(static_cast<float>(0.5 + 0.4 * direction[channel]));
    }
  const auto file = temporary_file("panorama.png");
  EXPECT_TRUE(write_png(file, picture));
  return std::make_shared<const Environment>(Texture::read(file).value());
}

constexpr PictureSize size{96, 64};

TEST(BackdropView, an_environment_is_seen_where_the_rays_of_the_camera_go) {
  const Backdrop backdrop{.environment = smooth_environment()};
  for (const View& view : {View{0, 0}, View{90, 0}, View{36, 22}, View{180, -40}}) {
    const Camera camera = orbit_camera(view, size, {1, 2, 3}, 5);
    const BackdropView seen(backdrop, camera, size);
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(95, 0), std::pair(20, 63)}) {
      const Eigen::Vector3f direction =
          camera.direction(static_cast<float>(x) / 47.5F - 1, 1 - static_cast<float>(y) / 31.5F)
              .normalized();
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(seen.at(x, y)[channel], 0.5F + 0.4F * direction[channel], 0.02F)
            << view.azimuth_deg << " " << x << " " << y;
    }
  }
}

// Tiles that hold a part of the ribbon must not differ from the others where it is not seen.
TEST(BackdropView, is_behind_everything_in_covered_tiles_and_in_others) {
  RenderScene scene(test::quad_ribbon());
  scene.set_ribbon(test::flat_quad());
  RenderSettings settings;
  settings.backdrop.environment = smooth_environment();
  const Camera camera = orbit_camera({20, 30}, size, {0, 0, 0}, 12);
  const BackdropView seen(settings.backdrop, camera, size);
  for (const bool smooths : {false, true}) {
    settings.quality = {.samples = 4, .most_samples = 4, .smooth_sky = smooths};
    const LightPicture light = Renderer(settings).render(scene, camera, size).light;
    int others = 0;
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        const Color& pixel = light.pixels[static_cast<std::size_t>(y) * size.width + x];
        others += (pixel - seen.at(x, y)).abs().maxCoeff() > 1e-6F ? 1 : 0;
      }
    EXPECT_GT(others, 50) << "the ribbon";
    EXPECT_LT(others, 1500) << "and nothing else: it lies in tiles of twice as many pixels";
  }
}

}  // namespace ribbon::backdrop_view_test
