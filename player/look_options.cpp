#include "player/look_options.h"

#include <memory>
#include <utility>

namespace ribbon {

namespace {

void add_quality_options(Arguments& arguments, LookTexts& texts) {
  arguments
      .add("--quality", texts.quality, "NAME",
           "draft (sun and its shadow), standard (and what the sky cannot reach), final (and light "
           "from cloth to cloth)")
      .one_of({"draft", "standard", "final"})
      .with_default_shown();
  const auto samples = arguments.add(
      "--samples", texts.samples, {1, 4096}, "N",
      "samples in every pixel, whatever the quality says; no smoothing (of a preview 1, or "
      "with more than 1 always 4)");
  arguments
      .add(
          "--noise", texts.noise, {0.01, 100}, "X",
          "samples until the estimated error of each region is below X levels of 255; no smoothing")
      .excludes(samples);
}

void add_scene_options(Arguments& arguments, LookTexts& texts) {
  const auto texture = arguments.add(
      "--texture", texts.texture, "FILE",
      "PNG on the cloth instead of the built-in pattern: as high as the ribbon is wide, repeated");
  arguments.add("--texture-back", texts.texture_back, "FILE", "PNG on its back (default: the same)")
      .needs(texture);
  arguments.add("--thickness", texts.thickness_mm, {0, 1000}, "MM",
                "of the cloth, as it is seen at the selvages; layers that are pressed together get "
                "less (default: 0)");
  arguments.flag("--ground", texts.ground, "a floor that shows the shadows");
  arguments.add("--environment", texts.environment, "FILE",
                "PNG of a panorama, whose light takes the place of the even sky's");
  arguments
      .add("--backdrop", texts.backdrop, "WORD",
           "what is seen behind everything: a gradient, or the environment")
      .one_of({"gradient", "environment"})
      .with_default_shown();
  arguments.add("--sun", texts.sun, {0, 100}, "X", "the sun X times as bright; 0: none")
      .with_default_shown();
  arguments
      .add("--exposure", texts.exposure, {-10, 10}, "STOPS",
           "each doubles the light of the picture")
      .with_default_shown();
  arguments
      .add("--tone", texts.tone, "NAME",
           "linear: what is brighter than white is cut off; soft: it comes ever closer to white")
      .one_of({"linear", "soft"})
      .with_default_shown();
}

Result<std::shared_ptr<const Texture>> texture_of(const std::filesystem::path& file) {
  if (file.empty()) return nullptr;
  return Texture::read(file).map(
      [](Texture&& texture) { return std::make_shared<const Texture>(std::move(texture)); });
}

Result<Lighting> lighting_of(const LookTexts& texts) {
  Lighting lighting;
  lighting.sun *= static_cast<float>(texts.sun);
  if (texts.environment.empty()) return lighting;
  auto panorama = Texture::read(texts.environment);
  if (!panorama) return tl::unexpected(panorama.error());
  lighting.environment = std::make_shared<const Environment>(std::move(*panorama));
  return lighting;
}

Result<ClothColors> cloth_of(const LookTexts& texts) {
  auto front = texture_of(texts.texture);
  if (!front) return tl::unexpected(front.error());
  auto back = texture_of(texts.texture_back);
  if (!back) return tl::unexpected(back.error());
  return ClothColors{std::move(*front), std::move(*back)};
}

constexpr int most_samples_for_noise = 4096;

// The first samples of a pixel must find what is there. So many do when they are about half of what
// it takes in the end.
int first_samples_for(float noise) {
  if (noise >= 8) return 4;
  return noise >= 4 ? 8 : 16;
}

Quality quality_of(const LookTexts& texts) {
  Quality quality = *quality_named(texts.quality);
  if (texts.samples == 0 && texts.noise == 0) return quality;
  quality.smooth_sky = false;
  quality.least_gain = 0;
  quality.noise = static_cast<float>(texts.noise);
  if (texts.samples > 0) {
    quality.samples = quality.most_samples = texts.samples;
  } else {
    quality.samples = first_samples_for(quality.noise);
    quality.most_samples = most_samples_for_noise;
  }
  return quality;
}

}  // namespace

void add_look_options(Arguments& arguments, LookTexts& texts) {
  add_quality_options(arguments, texts);
  add_scene_options(arguments, texts);
}

Result<RenderSettings> read_look(const LookTexts& texts) {
  RenderSettings settings;
  settings.quality = quality_of(texts);
  settings.tone = {static_cast<float>(texts.exposure), texts.tone == "soft"};
  settings.thickness_m = static_cast<float>(texts.thickness_mm / 1000);
  settings.ground = texts.ground;
  auto cloth = cloth_of(texts);
  if (!cloth) return tl::unexpected(cloth.error());
  settings.cloth = std::move(*cloth);
  auto lighting = lighting_of(texts);
  if (!lighting) return tl::unexpected(lighting.error());
  settings.lighting = std::move(*lighting);
  if (texts.backdrop == "environment") {
    if (!settings.lighting.environment)
      return failure("--backdrop environment", "there is no environment", "add --environment FILE");
    settings.backdrop.environment = settings.lighting.environment;
  }
  return settings;
}

}  // namespace ribbon
