#include "player/render/render.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "geometry/solids.h"
#include "parallel/any_threads.h"
#include "player/quads.h"
#include "player/render/cloth_pattern.h"
#include "player/render/ray_log.h"

namespace ribbon::render_test {

// Looks at (x, y, 0) from `side` times 10 m along z and sees 0.2 mm: one point of the cloth.
Camera close_up(float x, float y, float side) {
  Camera camera;
  camera.eye = {x, y, 10 * side};
  camera.world_from_camera = Eigen::Vector3f(side, 1, side).asDiagonal();
  camera.half_width = camera.half_height = 1e-5F;
  return camera;
}

Lighting only_sun(const Eigen::Vector3f& towards) {
  Lighting lighting;
  lighting.sun_direction = towards.normalized();
  lighting.sun = {0.9F, 0.6F, 0.3F};
  lighting.sun_radius = 0;
  lighting.sky_above = lighting.sky_below = Color::Zero();
  return lighting;
}

Lighting only_sky(const Color& above, const Color& below) {
  Lighting lighting = only_sun({0, 0, 1});
  lighting.sun = Color::Zero();
  lighting.sky_above = above;
  lighting.sky_below = below;
  lighting.bounce = 0;
  return lighting;
}

RenderScene flat_scene(const std::optional<TriangleMesh>& obstacle = std::nullopt) {
  RecordingHeader header = test::quad_ribbon();
  header.obstacle = obstacle;
  RenderScene scene(header);
  scene.set_ribbon(test::flat_quad());
  return scene;
}

// Sees from `height` along z what lies about the origin.
Camera from_above(float height, float half_width, float half_height) {
  return {.eye = {0, 0, height}, .half_width = half_width, .half_height = half_height};
}

Quality with_samples(int samples) {
  return {.samples = samples, .most_samples = samples};
}

LightPicture render(const RenderScene& scene, const Camera& camera, PictureSize size, int samples,
                    const Lighting& lighting = {}, const Backdrop& backdrop = {}) {
  return Renderer({with_samples(samples), lighting, backdrop}).render(scene, camera, size).light;
}

// What the middle of a 1 x 1 picture shows.
Color radiance(const RenderScene& scene, const Camera& camera, const Lighting& lighting,
               int samples = 16) {
  return render(scene, camera, {1, 1}, samples, lighting).pixels[0];
}

void expect_color(const Color& color, const Color& expected, float tolerance = 1e-4F) {
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(color[channel], expected[channel], tolerance) << "channel " << channel;
}

TEST(Render, cloth_that_faces_the_sun_returns_its_colour_of_the_light) {
  const Lighting lighting = only_sun({0, 0, -1});
  expect_color(radiance(flat_scene(), close_up(0, 0, -1), lighting),
               cloth_back(0, 0.5F, 0) * lighting.sun);
}

TEST(Render, light_falls_off_with_the_cosine) {
  const Lighting lighting = only_sun({0, std::sqrt(3.0F), -1});  // 60 degrees off
  expect_color(radiance(flat_scene(), close_up(0, 0, -1), lighting),
               cloth_back(0, 0.5F, 0) * lighting.sun * 0.5F);
}

TEST(Render, light_from_behind_does_not_come_through) {
  expect_color(radiance(flat_scene(), close_up(0, 0, -1), only_sun({0, 0, 1})), Color::Zero());
}

TEST(Render, each_side_has_its_own_colours_at_their_places) {
  // x from -2 to 2 is 0 to 4 ribbon widths along, y from -0.5 to 0.5 is 0 to 1 across.
  for (const float x : {-1.9F, -0.77F, 0.31F, 1.5F})
    for (const float y : {-0.45F, -0.2F, 0.33F}) {
      const float along = x + 2;
      const float across = y + 0.5F;
      const Lighting front = only_sun({0, 0, 1});
      const Lighting back = only_sun({0, 0, -1});
      expect_color(radiance(flat_scene(), close_up(x, y, 1), front),
                   cloth_front(along, across, 0) * front.sun, 0.01F);
      expect_color(radiance(flat_scene(), close_up(x, y, -1), back),
                   cloth_back(along, across, 0) * back.sun);
    }
}

TEST(Render, numbers_are_shown_as_places_on_a_map_from_both_sides) {
  RenderScene scene = flat_scene();
  scene.color_ribbon({0, 0, 1, 1}, sequential_map());  // from the first row to the second
  for (const float side : {1.0F, -1.0F})
    for (const float x : {-1.9F, -0.77F, 0.31F, 1.5F}) {
      const Lighting sun = only_sun({0, 0, side});
      expect_color(radiance(scene, close_up(x, 0.2F, side), sun),
                   sequential_map().at((x + 2) / 4) * sun.sun, 1e-3F);
    }
}

TEST(Render, the_open_sky_gives_its_mean) {
  const Color above(0.9F, 0.6F, 0.3F);
  const Color below(0.1F, 0.2F, 0.3F);
  expect_color(radiance(flat_scene(), close_up(0, 0, -1), only_sky(above, below), 1),
               cloth_back(0, 0.5F, 0) * (above + below) / 2);
}

TEST(Render, a_point_in_shadow_sees_no_sun) {
  // A plate above the middle, in the way of light that comes at 45 degrees, not of the camera.
  const RenderScene scene = flat_scene(
      quad_mesh({-0.2F, 0.8F, -1}, {0.2F, 0.8F, -1}, {0.2F, 1.2F, -1}, {-0.2F, 1.2F, -1}));
  const Lighting lighting = only_sun({0, 1, -1});
  expect_color(radiance(scene, close_up(0, 0, -1), lighting), Color::Zero());
  expect_color(radiance(scene, close_up(0.5F, 0, -1), lighting),
               cloth_back(0, 0.5F, 0) * lighting.sun * std::sqrt(0.5F));
}

TEST(Render, a_high_wall_hides_half_of_the_sky) {
  const RenderScene scene = flat_scene(
      quad_mesh({0.02F, -900, 0}, {0.02F, -900, -900}, {0.02F, 900, -900}, {0.02F, 900, 0}));
  Lighting lighting = only_sky(Color::Ones(), Color::Ones());
  const Camera camera = close_up(-0.05F, 0, -1);
  // From 0.07 m beside an endless wall, all directions beyond the vertical are hidden: one half.
  expect_color(radiance(scene, camera, lighting, 1024), cloth_back(0, 0.5F, 0) / 2, 0.01F);
  lighting.bounce = 0.5F;
  const Color cloth = cloth_back(0, 0.5F, 0);
  expect_color(radiance(scene, camera, lighting, 1024), cloth / 2 + cloth / 4, 0.01F);
}

TEST(Render, a_soft_sun_has_a_half_shadow_at_the_edge) {
  const RenderScene scene = flat_scene(quad_mesh({0, -1, -1}, {0, 1, -1}, {1, 1, -1}, {1, -1, -1}));
  Lighting lighting = only_sun({1, 0, -1});
  lighting.sun_radius = 0.1F;
  // Seen from x = -1 the plate's edge at (0, -1) cuts the sun's disc in halves.
  expect_color(radiance(scene, close_up(-1, 0, -1), lighting, 1024),
               cloth_back(0, 0.5F, 0) * lighting.sun * std::sqrt(0.5F) / 2, 0.01F);
}

TEST(Render, beside_everything_there_is_the_backdrop) {
  const Backdrop backdrop{{0.2F, 0.4F, 0.6F}, {0.6F, 0.4F, 0.2F}};
  const LightPicture picture =
      render(flat_scene(), close_up(50, 0, -1), {32, 64}, 1, Lighting{}, backdrop);
  expect_color(picture.pixels.front(), {0.2F, 0.4F, 0.6F}, 0.01F);
  expect_color(picture.pixels.back(), {0.6F, 0.4F, 0.2F}, 0.01F);
}

// A tube of 12 flat sides, its axis along y.
TriangleMesh coarse_tube() {
  return tube(1, -5, 5, 12);
}

TEST(Render, grazing_light_is_not_cut_off_by_flat_triangles) {
  RecordingHeader header = test::quad_ribbon();
  header.obstacle = coarse_tube();
  RenderScene scene(header);
  scene.set_ribbon(test::flat_quad().array() + 100);
  const LightPicture picture =
      render(scene, from_above(10, 0.1F, 0.01F), {400, 1}, 16, only_sun({0.951F, 0, -0.309F}));
  // The sun stands 108 degrees from the front, so the smooth tube is lit from 18 degrees on. The
  // flat side from 0 to 30 degrees, here up to pixel 309, faces away from it as a whole.
  for (int x = 285; x < 370; ++x) {
    const float lit = picture.pixels[x][0];
    EXPECT_GT(lit, 0.02F) << x;
    EXPECT_GE(lit, picture.pixels[x - 3][0] - 1e-3F) << "dark gap before " << x;
  }
}

// Waves that shade and hide each other. A refitted tree comes from where they lay mirrored.
RenderScene wavy_scene(RibbonTree tree = RibbonTree::rebuilt) {
  RecordingHeader header = test::quad_ribbon();
  header.grid = {60, 8};
  header.uv.resize(2, 480);
  Eigen::Matrix3Xf positions(3, 480);
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 8; ++j) {
      const auto s = static_cast<float>(i) / 59;
      const auto t = static_cast<float>(j) / 7;
      const Eigen::Index p = header.grid.particle(i, j);
      header.uv.col(p) << s, t;
      positions.col(p) << 4 * s - 2, t - 0.5F, 0.2F * std::sin(40 * s + t);
    }
  header.obstacle = coarse_tube();
  RenderScene scene(header);
  scene.set_ribbon(positions.colwise().reverse());
  scene.set_ribbon(positions, {}, tree);
  return scene;
}

TEST(Render, pixels_do_not_depend_on_the_tree) {
  const Camera camera = from_above(12, 0.2F, 0.1F);
  const RenderScene rebuilt = wavy_scene(RibbonTree::rebuilt);
  const RenderScene refitted = wavy_scene(RibbonTree::refitted);
  for (const char* quality : {"draft", "final"}) {
    const auto shown = [&](const RenderScene& scene) {
      Renderer renderer({*quality_named(quality), {}, {}});
      return encode_srgb(renderer.render(scene, camera, {203, 101}).light).rgb;
    };
    EXPECT_EQ(shown(rebuilt), shown(refitted)) << quality;
  }
}

TEST(Render, pixels_are_the_same_for_any_number_of_threads) {
  const RenderScene scene = wavy_scene();
  const Camera camera = from_above(12, 0.2F, 0.1F);
  for (const char* quality : {"draft", "standard", "final"})
    same_for_any_threads([&] {
      Renderer renderer({*quality_named(quality), {}, {}});
      return encode_srgb(renderer.render(scene, camera, {203, 101}).light).rgb;
    });
}

TEST(Render, tiles_left_out_would_have_shown_nothing_else) {
  // A speck behind the eye marks every tile; without it only the touched ones are traced.
  TriangleMesh speck{"speck", Eigen::Matrix3Xf(3, 3), Eigen::Vector3i(0, 1, 2)};
  speck.vertices << 0, 0.001F, 0, 0, 0, 0.001F, 13, 13, 13;
  const Camera camera = from_above(12, 0.4F, 0.4F);
  const Lighting lighting = only_sun({0.3F, 0.2F, -1});
  const auto picture = [&](const RenderScene& shown) {
    return encode_srgb(render(shown, camera, {150, 150}, 16, lighting)).rgb;
  };
  EXPECT_EQ(picture(flat_scene(coarse_tube())),
            picture(flat_scene(together(coarse_tube(), speck))));
}

TEST(Render, light_from_cloth_to_cloth_is_the_light_that_it_received) {
  // A wall hides half of an even sky. It sees between a half of the sky itself, at its foot, and
  // all of it high up, and returns about half of that.
  const RenderScene scene = flat_scene(
      quad_mesh({0.02F, -900, 0}, {0.02F, -900, -900}, {0.02F, 900, -900}, {0.02F, 900, 0}));
  RenderSettings settings{with_samples(4096), only_sky(Color::Ones(), Color::Ones()), {}};
  settings.quality.sky = SkyLight::bounced;
  const Color shown =
      Renderer(settings).render(scene, close_up(-0.05F, 0, -1), {1, 1}).light.pixels[0];
  const Color white = Color::Ones() / 2;  // without the wall's own light
  const Color from_wall = shown / cloth_back(0, 0.5F, 0) - white;
  EXPECT_GT(from_wall.minCoeff(), 0.12F);
  EXPECT_LT(from_wall.maxCoeff(), 0.3F);
}

double mean_square(const Picture& a, const Picture& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::pow(a.rgb[i] - b.rgb[i], 2);
  return sum / static_cast<double>(a.rgb.size());
}

TEST(Render, the_ground_is_the_backdrop_where_it_is_lit_and_darker_where_it_is_not) {
  RenderScene scene = flat_scene();  // upright, from y = -0.5 to 0.5, in the plane z = 0
  scene.set_ground(-1);
  const Backdrop backdrop{{0.5F, 0.6F, 0.7F}, {0.5F, 0.6F, 0.7F}};
  Camera camera;  // looks straight down past the cloth
  camera.world_from_camera << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  camera.half_width = camera.half_height = 1e-3F;
  const auto shown = [&](float z) {
    camera.eye = {0, 5, z};
    RenderSettings settings{with_samples(16), only_sun({0, 1, -1}), backdrop};
    return Renderer(settings).render(scene, camera, {1, 1}).light.pixels[0];
  };
  expect_color(shown(-2), backdrop.top);  // on the sun's side
  expect_color(shown(1), Color::Zero());  // the cloth is in the way
  expect_color(shown(3), backdrop.top);   // beyond its shadow
}

TEST(Render, noise_is_sampled_away_until_it_is_below_what_was_asked_for) {
  const RenderScene scene = wavy_scene();
  const Camera camera = from_above(12, 0.2F, 0.1F);
  const auto picture = [&](const Quality& quality) {
    return Renderer({quality, {}, {}}).render(scene, camera, {160, 80});
  };
  const Picture reference = encode_srgb(picture(with_samples(1024)).light);
  double samples = 0;
  for (const float noise : {4.0F, 2.0F}) {
    const Rendered rendered = picture({.samples = 8, .most_samples = 4096, .noise = noise});
    const double error = std::sqrt(mean_square(encode_srgb(rendered.light), reference));
    EXPECT_LT(error, noise);
    EXPECT_GT(error, noise / 2.5) << "more samples than it takes";
    EXPECT_LE(rendered.report.error, noise);
    EXPECT_EQ(rendered.report.wanting, 0);
    EXPECT_GT(rendered.report.samples, samples) << "less noise takes more samples";
    samples = rendered.report.samples;
    const auto as_many = static_cast<int>(std::ceil(samples));
    EXPECT_LT(error,
              std::sqrt(mean_square(encode_srgb(picture(with_samples(as_many)).light), reference)))
        << "samples went where they help less";
  }
  EXPECT_GT(picture({.samples = 4, .most_samples = 8, .noise = 0.5F}).report.wanting, 0.01);
}

TEST(Render, a_smoothed_sky_is_nearer_to_many_samples_than_its_own_few) {
  const RenderScene scene = wavy_scene();
  const Camera camera = from_above(12, 0.2F, 0.1F);
  const auto picture = [&](const Quality& quality) {
    return encode_srgb(Renderer({quality, only_sky(Color::Ones(), Color::Ones()), {}})
                           .render(scene, camera, {160, 80})
                           .light);
  };
  const Picture reference = picture(with_samples(1024));
  Quality few = with_samples(4);
  const double rough = mean_square(picture(few), reference);
  few.smooth_sky = true;
  EXPECT_LT(mean_square(picture(few), reference), rough / 1.5);
}

TEST(Render, a_smoothed_sky_leaves_outlines_as_they_are) {
  const RenderScene scene = flat_scene();
  const Backdrop black{Color::Zero(), Color::Zero()};
  const auto picture = [&](bool smooths) {
    Quality quality = with_samples(16);
    quality.smooth_sky = smooths;
    return Renderer({quality, only_sky(Color::Ones(), Color::Ones()), black})
        .render(scene, from_above(12, 0.4F, 0.2F), {160, 80})
        .light;
  };
  const LightPicture plain = picture(false);
  const LightPicture smooth = picture(true);
  for (std::size_t pixel = 0; pixel < plain.pixels.size(); ++pixel)
    expect_color(smooth.pixels[pixel], plain.pixels[pixel]);
}

TEST(Render, the_sky_of_a_smooth_surface_is_asked_for_by_its_first_samples) {
  RenderScene scene = wavy_scene();
  RayLog log;
  scene.log_rays_to(&log);
  const Quality quality{.samples = 4, .most_samples = 64, .noise = 1, .smooth_sky = true};
  Renderer({quality, {}, {}}).render(scene, from_above(12, 0.2F, 0.1F), {160, 80});
  std::size_t seen = 0;
  std::size_t sky = 0;
  for (const LoggedRays& logged : log.batches()) {
    if (logged.question == RayQuestion::first_hit_similar) seen += logged.rays.count;
    if (logged.question == RayQuestion::free_mixed) sky += logged.rays.count;
  }
  EXPECT_GT(sky, 0U);
  EXPECT_LT(sky, seen / 3) << "samples that find edges and patterns need no more of it";
}

TEST(Render, pictures_do_not_depend_on_those_before) {
  const RenderScene scene = wavy_scene();
  const RenderSettings settings{*quality_named("standard"), {}, {}};
  Renderer used(settings);
  used.render(scene, from_above(5, 0.4F, 0.4F), {64, 64});
  const Camera camera = from_above(12, 0.4F, 0.4F);
  const auto shown = [&](Renderer& renderer) {
    return encode_srgb(renderer.render(scene, camera, {64, 64}).light).rgb;
  };
  Renderer fresh(settings);
  EXPECT_EQ(shown(used), shown(fresh));
}

}  // namespace ribbon::render_test
