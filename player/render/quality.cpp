#include "player/render/quality.h"

namespace ribbon {

// Measured (docs/play.md): beside 1024 samples standard comes to 49 dB and more, final to 56 to 60.
std::optional<Quality> quality_named(const std::string& name) {
  if (name == "draft") return Quality{.sky = SkyLight::open, .samples = 1, .most_samples = 1};
  if (name == "standard")
    return Quality{.sky = SkyLight::occluded,
                   .samples = 4,
                   .most_samples = 64,
                   .least_gain = 4,
                   .smooth_sky = true};
  if (name == "final")
    return Quality{
        .sky = SkyLight::bounced, .samples = 16, .most_samples = 256, .least_gain = 0.05F};
  return std::nullopt;
}

}  // namespace ribbon
